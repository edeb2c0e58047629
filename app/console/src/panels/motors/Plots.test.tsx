// SPDX-License-Identifier: Apache-2.0
// Rule under test: the chosen axes are drawn, can be held still, are read at a cursor and saved.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { saveText } from "../../words/download";
import { makeAxis, makeRobot } from "../../testing/robot";
import { Trace, TRACE_S } from "../../words/trace";
import { Plots } from "./Plots";

vi.mock("../../words/download", () => ({ saveText: vi.fn() }));

/** Where 30 s ago and the end stand in a plot whose width is not known. */
const [LEFT, RIGHT] = [64, 580];

const axes = [makeAxis("head"), makeAxis("yaw", { unit: "deg", position: 7 })];
let trace: Trace;
let timeUs: number;

function take(position: number): void {
  const robot = makeRobot({}, [{ ...axes[0]!, position }, axes[1]!]);
  timeUs += 50_000;
  robot.motors.time_us = timeUs;
  trace.take(robot, timeUs / 1000);
}

/** The points of that curve in each plot, each stretch between gaps: from 30 s before to the end, and as high as the plot. */
function drawn(quantity: string): [number, number][][][] {
  return [...document.querySelectorAll(`.plot .plot-line-${quantity}`)].map(
    (curve) =>
      (curve.getAttribute("d") ?? "")
        .replaceAll("h0", "")
        .split("M")
        .slice(1)
        .map((stretch) =>
          stretch.split("L").map((point): [number, number] => {
            const [x = NaN, y = NaN] = point.split(",").map(Number);
            return [((x - RIGHT) / (RIGHT - LEFT)) * TRACE_S, y];
          }),
        ),
  );
}

function heights(quantity: string): number[] {
  return drawn(quantity)
    .flat(2)
    .map(([, y]) => y);
}

function readings(): string[] {
  return [...document.querySelectorAll(".plot-reading")].map((one) =>
    [...one.children].map(({ textContent }) => textContent).join("; "),
  );
}

beforeEach(() => {
  trace = new Trace();
  timeUs = 0;
  take(1);
  take(2);
  vi.stubGlobal(
    "ResizeObserver",
    class {
      observe(): void {}
      disconnect(): void {}
    },
  );
});

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

test("SWR-CON-027 the first axis is drawn at the beginning, others when they are chosen", () => {
  render(<Plots axes={axes} trace={trace} />);
  expect(document.querySelectorAll(".plot")).toHaveLength(3);
  fireEvent.click(screen.getByRole("checkbox", { name: "yaw" }));
  expect(document.querySelectorAll(".plot")).toHaveLength(6);
  fireEvent.click(screen.getByRole("checkbox", { name: "head" }));
  expect(document.querySelectorAll(".plot")).toHaveLength(3);
  expect(screen.getByRole("heading").textContent).toBe("yaw");
});

test("SWR-CON-027 a value stands at its time, and the higher the greater it is", () => {
  for (let count = 0; count < 20; count += 1) {
    take(2);
  }
  render(<Plots axes={axes} trace={trace} />);
  const [[points = []] = []] = drawn("position");
  expect(points).toHaveLength(22);
  expect(points[0]?.[0]).toBeCloseTo(-1.05, 1);
  expect(points.at(-1)?.[0]).toBe(0);
  const [one = 0, two = 0] = heights("position");
  const [setpoint = 0] = heights("setpoint");
  const [goal = 0] = heights("goal");
  // 1, 2, 12.5 and 20 mm, in this scale.
  expect((two - setpoint) / (one - two)).toBeCloseTo(10.5, 0);
  expect((setpoint - goal) / (one - two)).toBeCloseTo(7.5, 0);
});

test("SWR-CON-027 a gap is drawn as a gap", () => {
  timeUs += 5_000_000;
  take(3);
  take(4);
  render(<Plots axes={axes} trace={trace} />);
  expect(drawn("position")[0]?.map((stretch) => stretch.length)).toEqual([
    2, 2,
  ]);
});

test("SWR-CON-027 a sample between two gaps is drawn as a point", () => {
  timeUs += 5_000_000;
  take(3);
  timeUs += 5_000_000;
  take(4);
  render(<Plots axes={axes} trace={trace} />);
  const path = document.querySelector(".plot .plot-line-position");
  expect(path?.getAttribute("d")).toMatch(/M[\d.]+,[\d.]+h0M/);
});

test("SWR-CON-027 the scales have round numbers", () => {
  render(<Plots axes={axes} trace={trace} />);
  const words = [...document.querySelectorAll(".plot")].map((plot) =>
    [...plot.querySelectorAll("text")].map(({ textContent }) => textContent),
  );
  const times = ["-30 s", "-25 s", "-20 s", "-15 s", "-10 s", "-5 s", "0 s"];
  expect(words).toEqual([
    [...times, "0", "5", "10", "15", "20"],
    [...times, "0.5", "1.0", "1.5"],
    [...times, "-100", "-50", "0", "50", "100"],
  ]);
});

test("SWR-CON-027 a plot has its numbers in words as well", () => {
  render(<Plots axes={axes} trace={trace} />);
  expect(readings()).toEqual([
    "Now; set-point 12.50 mm; position 2.00 mm; goal 20.00 mm; speed 1.0 mm/s; output 0 %",
  ]);
});

test("SWR-CON-027 what is new is drawn", () => {
  const { rerender } = render(<Plots axes={axes} trace={trace} />);
  take(3);
  rerender(<Plots axes={axes} trace={trace} />);
  expect(heights("position")).toHaveLength(3);
});

test("SWR-CON-027 a pause holds the plots and not the robot", () => {
  const { rerender } = render(<Plots axes={axes} trace={trace} />);
  fireEvent.click(screen.getByRole("button", { name: "Pause" }));
  take(3);
  rerender(<Plots axes={axes} trace={trace} />);
  expect(heights("position")).toHaveLength(2);
  expect(readings()[0]).toMatch(/^At the pause; .*position 2\.00 mm/);
  fireEvent.click(screen.getByRole("button", { name: "Go on" }));
  expect(heights("position")).toHaveLength(3);
  expect(readings()[0]).toMatch(/^Now; .*position 3\.00 mm/);
});

function cursors(): (string | null)[] {
  return [...document.querySelectorAll(".plot-cursor")].map((one) =>
    one.getAttribute("d"),
  );
}

test("SWR-CON-027 the cursor reads all plots, by the pointer", () => {
  render(<Plots axes={axes} trace={trace} />);
  const plot = document.querySelector(".plot")!;
  fireEvent.pointerMove(plot, { clientX: RIGHT - 1 });
  expect(readings()[0]).toMatch(/^0\.05 s before; .*position 1\.00 mm/);
  expect(cursors()).toEqual(Array(3).fill(`M${RIGHT - 1},8V124`));
  fireEvent.pointerMove(plot, { clientX: RIGHT + 1 });
  expect(cursors()).toEqual([]);
  fireEvent.pointerMove(plot, { clientX: LEFT });
  expect(cursors()).toHaveLength(3);
  fireEvent.pointerLeave(plot);
  expect(readings()[0]).toMatch(/^Now; .*position 2\.00 mm/);
  expect(cursors()).toEqual([]);
});

test("SWR-CON-027 the cursor reads all plots, by keys", () => {
  render(<Plots axes={axes} trace={trace} />);
  fireEvent.change(screen.getByLabelText(/^Cursor/), {
    target: { value: "-0.05" },
  });
  expect(readings()[0]).toMatch(/^0\.05 s before; .*position 1\.00 mm/);
  expect(cursors()).toHaveLength(3);
});

test("SWR-CON-027 the chosen axes are saved as they are shown", () => {
  render(<Plots axes={axes} trace={trace} />);
  fireEvent.click(screen.getByRole("button", { name: "Pause" }));
  take(3);
  fireEvent.click(screen.getByRole("button", { name: "Save as CSV" }));
  const [name, type, text] = vi.mocked(saveText).mock.calls[0] ?? [];
  expect([name, type]).toEqual(["plot.csv", "text/csv"]);
  expect(text?.trim().split("\n")).toEqual([
    "time s,head set-point mm,head position mm,head speed mm/s,head output %,head goal mm",
    "0.000,12.5,1,1,0,20",
    "0.050,12.5,2,1,0,20",
  ]);
});
