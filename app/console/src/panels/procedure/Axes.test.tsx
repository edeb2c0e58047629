// SPDX-License-Identifier: Apache-2.0
// Rule under test: a row for each axis with set-point and position, and why it does not move.
import { cleanup, render, screen, within } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { Axis } from "@interface";
import { percentOf, Track } from "../../parts/drawn/Track";
import { makeAxis, makeBlockedAxis } from "../../testing/robot";
import { Axes } from "./Axes";

const estop = { name: "ESTOP_PULLED", text: "The e-stop is pulled." } as const;
const homed = { name: "NOT_HOMED", text: "The axis is not homed." } as const;

function rowOf(name: string): HTMLElement {
  const row = screen.getByRole("rowheader", { name }).closest("tr");
  if (row === null) {
    throw new Error(`no row for ${name}`);
  }
  return row;
}

afterEach(cleanup);

test("SWR-CON-003 shows a row for each axis", () => {
  render(<Axes axes={[makeAxis("head"), makeAxis("yaw")]} />);
  expect(
    screen.getAllByRole("rowheader").map((cell) => cell.textContent),
  ).toEqual(["head", "yaw"]);
});

test("SWR-CON-003 shows set-point and position in the axis' unit", () => {
  const axis = makeAxis("yaw", {
    unit: "deg",
    setpoint: -3.456,
    position: 0.004,
  });
  render(<Axes axes={[axis]} />);
  const row = rowOf("yaw");
  expect(row.querySelector('[data-field="setpoint"]')?.textContent).toBe(
    "\u22123.46 °",
  );
  expect(row.querySelector('[data-field="position"]')?.textContent).toBe(
    "0.00 °",
  );
});

test("SWR-CON-003 describes the picture in words", () => {
  render(<Axes axes={[makeAxis("head")]} />);
  expect(
    screen.getByRole("img", {
      name: "head: set-point 12.50 mm, position 10.00 mm, limits 0.00 mm to 40.00 mm",
    }),
  ).toBeDefined();
});

test("SWR-CON-021 measures what is outside the limits as far as it is", () => {
  const axis = makeAxis("head", { minimum: -10, maximum: 30 });
  expect(percentOf(axis, -10)).toBe(0);
  expect(percentOf(axis, 10)).toBe(50);
  expect(percentOf(axis, 32)).toBe(105);
  expect(percentOf(axis, -14)).toBe(-10);
});

function markOf(axis: Axis): Element | null {
  const { container } = render(<Track axis={axis} />);
  return container.querySelector(".track-position");
}

test("SWR-CON-021 draws a position beyond its limit beyond it", () => {
  const upper = 92;
  const mark = markOf(makeAxis("yaw", { position: 42 }));
  expect(parseFloat(mark?.getAttribute("x") ?? "")).toBeGreaterThan(upper);
  expect(mark?.getAttribute("data-beyond")).toBe("0");
});

test("SWR-CON-021 points to a position that is too far for the drawing", () => {
  const mark = markOf(makeAxis("yaw", { position: -100 }));
  expect(mark?.getAttribute("x")).toBe("0%");
  expect(mark?.getAttribute("data-beyond")).toBe("-1");
});

test.each([
  ["fresh", "unknown"],
  ["leave", "unknown"],
  ["approach", "unknown"],
  ["back_off", "unknown"],
  ["latch", "unknown"],
  ["lost", "lost"],
] as const)(
  "SWR-CON-021 of a position that is %s says %s, and draws nothing",
  (reference, word) => {
    render(<Axes axes={[makeAxis("head", { reference })]} />);
    const row = rowOf("head");
    const cell = row.querySelector('[data-field="position"]');
    expect(cell?.querySelector(".place-word")?.textContent).toBe(word);
    expect(cell?.querySelector(".place-number")?.textContent).toBe(
      "counted 10.00 mm",
    );
    expect(row.querySelector(".track-position")).toBeNull();
    expect(row.querySelector(".track-setpoint")).toBeNull();
    expect(
      screen.getByRole("img", {
        name: `head: position ${word}, limits 0.00 mm to 40.00 mm`,
      }),
    ).toBeDefined();
  },
);

test("SWR-CON-021 shows a position that is unverified, but not as a fact", () => {
  render(<Axes axes={[makeAxis("head", { reference: "unverified" })]} />);
  const row = rowOf("head");
  const cell = row.querySelector('[data-field="position"]');
  expect(cell?.querySelector(".place-word")?.textContent).toBe("unverified");
  expect(cell?.querySelector(".place-number")?.textContent).toBe(
    "about 10.00 mm",
  );
  expect(row.querySelector(".track-position")).not.toBeNull();
});

test.each([
  ["fresh", "enabled, not homed yet"],
  ["lost", "enabled, position lost"],
  ["unverified", "enabled, position unverified"],
  ["taken", "enabled, taken in place"],
  ["verified", "enabled, verified"],
  ["back_off", "enabled, homing, backs off"],
] as const)(
  "SWR-REF-012 says of %s how far the position is trusted",
  (reference, text) => {
    render(<Axes axes={[makeAxis("feet", { reference })]} />);
    const row = rowOf("feet");
    expect(row.textContent).toContain(text);
    expect(row.querySelector('[data-field="position"]')).not.toBeNull();
  },
);

test("SWR-REF-012 says it of an axis that is not enabled too", () => {
  const axes = [
    makeAxis("feet", { power: "fault", reference: "lost" }),
    makeAxis("head", { power: "disabled", reference: "unverified" }),
  ];
  render(<Axes axes={axes} />);
  expect(rowOf("feet").textContent).toContain("faulty, position lost");
  expect(rowOf("head").textContent).toContain("disabled, position unverified");
});

test("SWR-CON-005 shows the reasons of an axis and since when", () => {
  render(<Axes axes={[makeAxis("head"), makeBlockedAxis("yaw", homed)]} />);
  const yaw = within(rowOf("yaw"));
  expect(yaw.getByText("The axis is not homed.")).toBeDefined();
  expect(yaw.getByText("for 5 s")).toBeDefined();
  expect(rowOf("head").textContent).toContain("May move, up to 100 % speed");
});

test("SWR-CON-005 states what holds for every axis once, above the rows", () => {
  const axes = [
    makeBlockedAxis("head", estop),
    makeBlockedAxis("yaw", estop, homed),
  ];
  render(<Axes axes={axes} />);
  expect(screen.getAllByText("The e-stop is pulled.")).toHaveLength(1);
  expect(rowOf("head").textContent).toContain(
    "As for every axis: The e-stop is pulled.",
  );
  expect(rowOf("yaw").textContent).toContain("The axis is not homed.");
  expect(rowOf("yaw").textContent).not.toContain("As for every axis");
});

test.each([
  ["All axes may move.", makeAxis("head")],
  ["Some axes may move.", makeBlockedAxis("head", estop)],
])("SWR-CON-005 keeps the place above the rows: %s", (text, head) => {
  render(<Axes axes={[head, makeAxis("yaw")]} />);
  expect(screen.getByText(text)).toBeDefined();
  expect(screen.queryByText("No axis may move:")).toBeNull();
});

test("SWR-CON-005 does not say that an axis may move when none does", () => {
  const axes = [makeBlockedAxis("head", estop), makeBlockedAxis("yaw", homed)];
  render(<Axes axes={axes} />);
  expect(screen.getByText("Each axis has a reason of its own.")).toBeDefined();
});
