// SPDX-License-Identifier: Apache-2.0
// Rule under test: expected membranes are typed in as depths, and shown with what became of them.
import { cleanup, fireEvent, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { Membranes } from "@interface";
import { leave, refusedHere, type Commander } from "../../testing/commander";
import { orderButton, showTargeting, write } from "../../testing/targeting";

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
  says: "A puncture is looked for. One may be missed, and one may be invented.",
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

function button(): HTMLButtonElement {
  return orderButton("Expect membranes");
}

afterEach(() => leave(commander));

test("SWR-PUNCT-620 depths are sent as they are typed in", async () => {
  commander = await showTargeting({ membranes: none }, "MEMBRANES");
  write(LABEL, "12.5, 30 −");
  expect(button().disabled).toBe(true);
  write(LABEL, "1 2 3 4 5 6 7 8 9");
  expect(button().disabled).toBe(true);
  write(LABEL, "20,55");
  expect(button().disabled).toBe(true);
  write(LABEL, "12.5, 30");
  fireEvent.click(button());
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/targeting/membranes",
      body: { id: 1, depths_mm: [12.5, 30] },
    },
  ]);
});

test("SWR-PUNCT-620 an empty field expects none", async () => {
  commander = await showTargeting({ membranes: membranes }, "MEMBRANES");
  expect(screen.getByLabelText<HTMLInputElement>(LABEL).value).toBe(
    "20.0 40.0 54.5",
  );
  write(LABEL, "");
  fireEvent.click(button());
  expect(commander.acts()[0]?.body).toEqual({ id: 1, depths_mm: [] });
});

test("SWR-PUNCT-620 what became of each is shown, and what can be found", async () => {
  commander = await showTargeting({ membranes: membranes });
  expect(
    screen.getByText(
      "20.0 mm found at 20.3 mm, 40.0 mm missed, 54.5 mm ahead; 1 left; 2 unexpected. A puncture is looked for. One may be missed, and one may be invented. " +
        "The needle is 47.3 mm deep; a force that falls by less than 169 mN is not found.",
    ),
  ).toBeTruthy();
  expect(button().disabled).toBe(true);
  expect(button().title || document.body.textContent).toContain(refusedHere);
});

test("SWR-PUNCT-620 none expected is shown as such, and nothing of a robot without a force sensor", async () => {
  commander = await showTargeting({ membranes: none });
  expect(
    screen.getByText(
      "none expected; 0 unexpected. No hand inserts the needle.",
    ),
  ).toBeTruthy();
  cleanup();
  commander = await showTargeting({ membranes: null });
  expect(screen.queryByText("Membranes")).toBeNull();
  expect(screen.queryByLabelText(LABEL)).toBeNull();
});
