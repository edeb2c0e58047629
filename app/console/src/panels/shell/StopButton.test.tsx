// SPDX-License-Identifier: Apache-2.0
// Rule under test: one press is one stop, a failed one cannot be overlooked, and "stopped" is never said from memory.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { requestStop, type StopResult } from "../../state/stop";
import { makeRobot } from "../../testing/robot";
import { StopButton } from "./StopButton";

vi.mock(import("../../state/stop"), async (original) => ({
  ...(await original()),
  requestStop: vi.fn(),
}));

const stopped = makeRobot({
  workphase: { name: "STOP", text: "Stopped by command." },
});
const moving = { freshness: "live", robot: makeRobot() } as const;
const seen = { freshness: "live", robot: stopped } as const;
const stale = { freshness: "stale", robot: stopped } as const;
let answers: ((result: StopResult) => void)[];

async function answer(press: number, isConfirmed: boolean): Promise<void> {
  await act(async () => {
    answers[press]?.({ isConfirmed, reason: "The server does not answer." });
    await Promise.resolve();
  });
}

function says(): string | null {
  return screen.getByRole("status").textContent;
}

function press(): void {
  fireEvent.click(screen.getByRole("button"));
}

beforeEach(() => {
  answers = [];
  vi.mocked(requestStop).mockImplementation(
    () => new Promise((resolve) => answers.push(resolve)),
  );
});

afterEach(() => {
  cleanup();
  vi.clearAllMocks();
});

test("SWR-CON-010 a held key asks once, and a new press asks again", () => {
  render(<StopButton view={moving} />);
  fireEvent.keyDown(window, { key: "Escape" });
  for (let repeat = 0; repeat < 60; repeat++) {
    fireEvent.keyDown(window, { key: "Escape", repeat: true });
  }
  expect(requestStop).toHaveBeenCalledTimes(1);
  fireEvent.keyUp(window, { key: "Escape" });
  fireEvent.keyDown(window, { key: "Escape" });
  expect(requestStop).toHaveBeenCalledTimes(2);
});

test("SWR-CON-007 a stop that failed is an alert that stays", async () => {
  const { rerender } = render(<StopButton view={moving} />);
  press();
  expect(screen.queryByRole("alert")).toBeNull();
  await answer(0, false);
  expect(screen.getByRole("alert").textContent).toContain("NOT STOPPED");
  rerender(<StopButton view={{ ...moving, robot: makeRobot() }} />);
  press();
  expect(screen.getByRole("alert").textContent).toContain("Release the pedal");
});

test("SWR-CON-007 the alert ends when control confirms another stop", async () => {
  render(<StopButton view={moving} />);
  press();
  await answer(0, false);
  press();
  await answer(1, true);
  expect(screen.queryByRole("alert")).toBeNull();
});

test("SWR-CON-007 the alert ends when control is seen to have stopped, and does not come back", async () => {
  const { rerender } = render(<StopButton view={moving} />);
  press();
  await answer(0, false);
  rerender(<StopButton view={seen} />);
  expect(screen.queryByRole("alert")).toBeNull();
  rerender(<StopButton view={moving} />);
  expect(screen.queryByRole("alert")).toBeNull();
});

test("SWR-CON-007 an old press that fails does not speak for the last one", async () => {
  render(<StopButton view={moving} />);
  press();
  press();
  await answer(1, true);
  await answer(0, false);
  expect(screen.queryByRole("alert")).toBeNull();
});

test("SWR-CON-008 stopped is said while it is seen, for a stop of any client", () => {
  const { rerender } = render(<StopButton view={seen} />);
  expect(says()).toBe("Control has stopped all motion.");
  rerender(<StopButton view={moving} />);
  expect(says()).not.toContain("stopped");
  rerender(<StopButton view={stale} />);
  expect(says()).not.toContain("stopped");
});

test("SWR-CON-008 a confirmed stop is no claim once the robot moves again", async () => {
  const { rerender } = render(<StopButton view={moving} />);
  press();
  await answer(0, true);
  expect(says()).toBe("A software stop. The e-stop is on the robot.");
  rerender(<StopButton view={stale} />);
  expect(says()).toContain("Whether it still stands is not known.");
});
