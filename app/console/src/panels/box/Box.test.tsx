// SPDX-License-Identifier: Apache-2.0
// Rule under test: the drawer shows the simulated box as it is, and gives it the orders of a person there.
import { fireEvent, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import type { Box as BoxState } from "@interface";
import { LOOK_MS } from "../../state/box";
import {
  answerWith,
  asked,
  beginBox,
  box,
  button,
  endBox,
  makeSlot,
  pass,
  show,
} from "../../testing/box";

beforeEach(beginBox);
afterEach(endBox);

test("SWR-CON-039 an answer that is no box is not shown as one", async () => {
  answerWith({} as BoxState);
  await show();
  screen.getByText("The simulated box has not answered.");
});

test.each([
  ["Pull e-stop", '{"estop":"pull"}'],
  ["Scanner on", '{"scanner":"on"}'],
  ["Free probe", '{"probe":"free"}'],
  ["Push 10 mm out", '{"push_mm":-10}'],
])("SWR-CON-040 %s is one order", async (name, order) => {
  await show();
  fireEvent.click(button(name));
  expect(asked).toEqual([order]);
});

function choose(name: string, value: string): void {
  const label = [...document.querySelectorAll("label")].find(
    (one) => one.querySelector(".box-name")?.textContent === name,
  );
  fireEvent.change(label?.querySelector("select") as Element, {
    target: { value },
  });
}

test("SWR-BOX-534 grip, tissue and faults of load cells are orders", async () => {
  await show();
  choose("Hand", "5000");
  choose("Load cell of the hand", "stuck");
  choose("Load cell of the needle", "drift");
  fireEvent.click(button("Make tissue whole"));
  fireEvent.click(button("Take tissue away"));
  expect(asked).toEqual([
    '{"grip_mn":5000}',
    '{"force_hand":"stuck"}',
    '{"force_needle":"drift"}',
    '{"tissue":"whole"}',
    '{"tissue":"none"}',
  ]);
});

test("SWR-BOX-534 the box is shown as it is", async () => {
  box.grip_mn = -1234;
  box.layers = 0;
  box.force_needle = "full";
  await show();
  expect(
    document.querySelector('[aria-label="Hand"] select')?.textContent,
  ).toContain("pulls with 1.234 N");
  expect(
    document.querySelector('[aria-label="Tissue"] strong')?.textContent,
  ).toBe("none");
  fireEvent.click(button("Put tissue there"));
  expect(asked).toEqual(['{"tissue":"usual"}']);
  expect(
    document.querySelector<HTMLSelectElement>(
      '[aria-label="Load cell of the needle"] select',
    )?.value,
  ).toBe("full");
});

test("SWR-BOX-778 the needle is shown where the box shows one", async () => {
  await show();
  expect(document.querySelector(".box-needle")).toBeNull();
  box.needle = {
    surface_mm: 30,
    turn_deg: 0,
    lag_deg: 0,
    way: [{ x_mm: 0, y_mm: 0, depth_mm: 2 }],
    target: null,
    image: null,
    curvature: 4100,
    torsion_deg: 45,
    images_period_ms: 2000,
    images_delay_ms: 500,
    images_noise_um: 500,
  };
  await pass(LOOK_MS);
  expect(document.querySelector(".box-needle")).not.toBeNull();
  fireEvent.click(button("Put a moving target there"));
  expect(asked).toEqual(['{"target":"usual"}']);
});

test("SWR-BOX-534 a box without a sensor card has neither handle nor tissue", async () => {
  box.slots = box.slots.filter(({ card_type }) => card_type !== "sensor");
  await show();
  expect(document.querySelector('[aria-label="Handle"]')).toBeNull();
  expect(document.querySelector('[aria-label="Tissue"]')).toBeNull();
});

test("SWR-CON-040 the button shows what is at the box, and the other way", async () => {
  box.is_estop_pulled = true;
  box.is_scanner_active = true;
  await show();
  fireEvent.click(button("Reset e-stop"));
  fireEvent.click(button("Scanner off"));
  fireEvent.click(button("Reach dose"));
  expect(asked).toEqual([
    '{"estop":"reset"}',
    '{"scanner":"off"}',
    '{"gate":"dose"}',
  ]);
});

test("SWR-CON-040 the lamps that are lit are named", async () => {
  const lamps = () =>
    document.querySelector('[aria-label="Lamps"] strong')?.textContent;
  await show();
  expect(lamps()).toBe("alive");
  box.is_lamp_may_move = true;
  box.is_lamp_moving = true;
  await pass(LOOK_MS);
  expect(lamps()).toBe("alive, may move, moving");
  box.is_lamp_alive = box.is_lamp_may_move = box.is_lamp_moving = false;
  box.is_lamp_fault = true;
  await pass(LOOK_MS);
  expect(lamps()).toBe("fault");
  box.is_lamp_fault = false;
  await pass(LOOK_MS);
  expect(lamps()).toBe("dark");
});

test("SWR-CON-040 a fault is caused, seen and mended", async () => {
  await show();
  fireEvent.change(screen.getByLabelText("Fault"), {
    target: { value: "card_fault silent" },
  });
  fireEvent.click(button("Do it"));
  expect(asked).toEqual(['{"slot":1,"card_fault":"silent"}']);
  box.slots[1] = makeSlot(1, { ...box.slots[1], card_fault: "silent" });
  await pass(LOOK_MS);
  screen.getByText(/1 yaw: card does not answer/);
  fireEvent.click(button("Mend 1 yaw: card"));
  expect(asked.at(-1)).toBe('{"slot":1,"card_fault":"normal"}');
});

test("SWR-CON-040 where no axis is, a card is put in, and nothing else fails", async () => {
  await show();
  fireEvent.change(screen.getByLabelText("Slot"), { target: { value: "2" } });
  const values = screen
    .getAllByRole<HTMLOptionElement>("option")
    .map((option) => option.value);
  expect(values).toContain("card_fault corrupt");
  expect(values).not.toContain("motor_fault stuck");
  fireEvent.change(screen.getByLabelText("Fault"), {
    target: { value: "plug analog" },
  });
  fireEvent.click(button("Do it"));
  expect(asked).toEqual(['{"slot":2,"plug":"analog"}']);
});

test("SWR-CON-040 an observer sees and works nothing", async () => {
  await show("OBSERVER");
  screen.getByText("Log in as operator to command.");
  const enabled = screen
    .getAllByRole<HTMLButtonElement>("button")
    .filter(({ disabled }) => !disabled);
  expect(enabled.map(({ textContent }) => textContent)).toEqual([
    "Close the simulated box",
  ]);
});
