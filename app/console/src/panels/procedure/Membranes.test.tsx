// SPDX-License-Identifier: Apache-2.0
// Rule under test: expected membranes are typed in as depths, and shown with what became of them.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import type { Membranes } from "@interface";
import {
  makeCommander,
  makeOutlook,
  refusedHere,
  type Commander,
} from "../../testing/commander";
import { makeRobot } from "../../testing/robot";
import { Aim } from "./Aim";
import { Targeting } from "./Targeting";

let commander: Commander;
const LABEL = "Membranes, mm below the entry point";

const membranes: Membranes = {
  expected: [
    { depth_mm: 20, found_mm: 20.3, state: "FOUND" },
    { depth_mm: 40, found_mm: null, state: "MISSED" },
    { depth_mm: 54.5, found_mm: null, state: "AHEAD" },
  ],
  left: 1,
  unexpected: 2,
  sight: "LOOKING",
  says: "A puncture would be found now.",
  depth_mm: 47.25,
  least_fall_mn: 169,
};

const none: Membranes = {
  expected: [],
  left: 0,
  unexpected: 0,
  sight: "OFF",
  says: "No hand inserts the needle.",
  depth_mm: null,
  least_fall_mn: null,
};

async function show(given: Membranes | null, ...acts: string[]): Promise<void> {
  commander = await makeCommander("OPERATOR");
  const robot = makeRobot({ authority: commander.authority });
  const targeting = { ...robot.targeting, membranes: given };
  render(
    <>
      <Targeting targeting={targeting} />
      <Aim
        robot={{ ...robot, targeting }}
        outlook={makeOutlook(...acts)}
        operation={commander.operation}
      />
    </>,
  );
}

function button(): HTMLButtonElement {
  return screen.getByRole<HTMLButtonElement>("button", {
    name: "Expect membranes",
  });
}

function write(value: string): void {
  fireEvent.change(screen.getByLabelText(LABEL), { target: { value } });
}

afterEach(() => {
  commander.operation.session.stop();
  cleanup();
  vi.unstubAllGlobals();
});

test("SWR-PUNCT-620 depths are sent as they are typed in", async () => {
  await show(none, "MEMBRANES");
  write("12.5, 30 −");
  expect(button().disabled).toBe(true);
  write("1 2 3 4 5 6 7 8 9");
  expect(button().disabled).toBe(true);
  write("20,55");
  expect(button().disabled).toBe(true);
  write("12.5, 30");
  fireEvent.click(button());
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/targeting/membranes",
      body: { id: 1, depths_mm: [12.5, 30] },
    },
  ]);
});

test("SWR-PUNCT-620 an empty field expects none", async () => {
  await show(membranes, "MEMBRANES");
  expect(screen.getByLabelText<HTMLInputElement>(LABEL).value).toBe(
    "20.0 40.0 54.5",
  );
  write("");
  fireEvent.click(button());
  expect(commander.acts()[0]?.body).toEqual({ id: 1, depths_mm: [] });
});

test("SWR-PUNCT-620 what became of each is shown, and what can be found", async () => {
  await show(membranes);
  expect(
    screen.getByText(
      "20.0 mm found at 20.3 mm, 40.0 mm missed, 54.5 mm ahead; 1 left; 2 unexpected. A puncture would be found now. " +
        "The needle is 47.3 mm deep; a force that falls by less than 169 mN is not found.",
    ),
  ).toBeTruthy();
  expect(button().disabled).toBe(true);
  expect(button().title || document.body.textContent).toContain(refusedHere);
});

test("SWR-PUNCT-620 none expected is shown as such, and nothing of a robot without a force sensor", async () => {
  await show(none);
  expect(
    screen.getByText(
      "none expected; 0 unexpected. No hand inserts the needle.",
    ),
  ).toBeTruthy();
  cleanup();
  await show(null);
  expect(screen.queryByText("Membranes")).toBeNull();
  expect(screen.queryByLabelText(LABEL)).toBeNull();
});
