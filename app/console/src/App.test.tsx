// SPDX-License-Identifier: Apache-2.0
// Rule under test: the stop stays and works after a failure of any part of the page.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { RobotState } from "@interface";
import { App, Emergency } from "./App";
import { Boundary } from "./parts/Boundary";
import { applyKeptTheme } from "./parts/ThemeChoice";
import { TelemetryStore } from "./state/store";
import { makeRobot } from "./testing/robot";
import { FakeSurroundings } from "./testing/surroundings";

const surroundings = new FakeSurroundings();
const fetched = vi.fn(() => Promise.resolve(new Response("{}")));

/** The state that a server of another build sends: without one of its fields. */
function without(path: string): RobotState {
  const robot = structuredClone(makeRobot()) as unknown as Record<
    string,
    unknown
  >;
  const names = path.split(".");
  let at: Record<string, unknown> = robot;
  for (const name of names.slice(0, -1)) {
    at = at[name] as Record<string, unknown>;
  }
  delete at[names.at(-1) ?? ""];
  return robot as unknown as RobotState;
}

function expectStop(): void {
  fetched.mockClear();
  fireEvent.click(screen.getByRole("button", { name: /STOP MOTION/ }));
  fireEvent.keyDown(window, { key: "Escape" });
  expect(fetched).toHaveBeenCalledTimes(2);
}

beforeEach(() => {
  vi.stubGlobal("fetch", fetched);
  vi.spyOn(console, "error").mockImplementation(() => undefined);
});

afterEach(() => {
  cleanup();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

const paths = [
  "status",
  "motors",
  "targeting",
  ...Object.keys(makeRobot().status).map((name) => `status.${name}`),
  ...Object.keys(makeRobot().motors).map((name) => `motors.${name}`),
  ...Object.keys(makeRobot().targeting).map((name) => `targeting.${name}`),
];

test.each(paths)(
  "SWR-CON-009 a state without %s leaves the stop",
  async (path) => {
    const store = new TelemetryStore(surroundings);
    store.start();
    render(<App store={store} />);
    act(() => surroundings.stream.send("state", without(path)));
    await act(() => Promise.resolve());
    expectStop();
    store.stop();
  },
);

test("SWR-CON-009 a page that cannot be shown at all leaves the stop", () => {
  const Broken = () => {
    throw new Error("broken");
  };
  render(
    <Boundary name="console" instead={<Emergency />}>
      <Broken />
    </Boundary>,
  );
  expectStop();
});

test("SWR-CON-009 a browser that refuses its storage shows the page", () => {
  vi.stubGlobal("localStorage", {
    getItem: () => {
      throw new DOMException("refused", "SecurityError");
    },
    setItem: () => {
      throw new DOMException("refused", "SecurityError");
    },
  });
  applyKeptTheme();
  render(<App store={new TelemetryStore(surroundings)} />);
  fireEvent.change(screen.getByRole("combobox", { name: "Theme" }), {
    target: { value: "light" },
  });
  expectStop();
});
