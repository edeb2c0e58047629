// SPDX-License-Identifier: Apache-2.0
// Rule under test: the chosen axes are drawn, can be held still, are read at a cursor and saved. The drawing itself is a
// library's; here it writes down what it is given.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { saveText } from "../download";
import { makeAxis, makeRobot } from "../testing/robot";
import { Trace } from "../trace";
import { Plots } from "./Plots";

interface Hooks {
  setCursor: ((plot: object) => void)[];
}

const drawn = vi.hoisted(() => ({
  plots: [] as {
    hooks: Hooks;
    data: unknown[];
    pointed: number[];
    isEnded: boolean;
  }[],
}));

vi.mock("uplot", () => ({
  default: class {
    hooks: Hooks;
    data: unknown[] = [];
    pointed: number[] = [];
    isEnded = false;

    constructor(options: { hooks: Hooks }) {
      this.hooks = options.hooks;
      drawn.plots.push(this);
    }

    setData(data: unknown[]): void {
      this.data = data;
    }

    setCursor({ left }: { left: number }): void {
      this.pointed.push(left);
    }

    valToPos(value: number): number {
      return value;
    }

    destroy(): void {
      this.isEnded = true;
    }
  },
}));
vi.mock("../download", () => ({ saveText: vi.fn() }));

const axes = [makeAxis("head"), makeAxis("yaw", { unit: "deg", position: 7 })];
let trace: Trace;
let timeUs: number;
let frame: () => void;

function take(position: number): void {
  const robot = makeRobot({}, [{ ...axes[0]!, position }, axes[1]!]);
  timeUs += 50_000;
  robot.motors.time_us = timeUs;
  trace.take(robot, timeUs / 1000);
}

function present() {
  return drawn.plots.filter(({ isEnded }) => !isEnded);
}

function readings(): string[] {
  return [...document.querySelectorAll(".plot-reading")].map((one) =>
    [...one.children].map(({ textContent }) => textContent).join("; "),
  );
}

beforeEach(() => {
  trace = new Trace();
  timeUs = 0;
  drawn.plots.length = 0;
  take(1);
  take(2);
  vi.stubGlobal(
    "ResizeObserver",
    class {
      observe(): void {}
      disconnect(): void {}
    },
  );
  vi.stubGlobal("requestAnimationFrame", (draw: () => void) => {
    frame = draw;
    return 1;
  });
  vi.stubGlobal("cancelAnimationFrame", () => undefined);
});

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

test("SWR-CON-027 the first axis is drawn at the beginning, others when they are chosen", () => {
  render(<Plots axes={axes} trace={trace} />);
  expect(present().map(({ data }) => data)).toEqual([
    [
      [-0.05, 0],
      [1, 2],
      [12.5, 12.5],
      [20, 20],
    ],
    [
      [-0.05, 0],
      [1, 1],
    ],
    [
      [-0.05, 0],
      [0, 0],
    ],
  ]);
  fireEvent.click(screen.getByRole("checkbox", { name: "yaw" }));
  expect(present()).toHaveLength(6);
  fireEvent.click(screen.getByRole("checkbox", { name: "head" }));
  expect(present()).toHaveLength(3);
  expect(present()[0]?.data[1]).toEqual([7, 7]);
});

test("SWR-CON-027 a plot has its numbers in words as well", () => {
  render(<Plots axes={axes} trace={trace} />);
  expect(readings()).toEqual([
    "Now; set-point 12.50 mm; position 2.00 mm; goal 20.00 mm; speed 1.0 mm/s; output 0 %",
  ]);
});

test("SWR-CON-027 a frame draws what is new", () => {
  render(<Plots axes={axes.slice(0, 1)} trace={trace} />);
  take(3);
  const last = present().at(-1);
  frame();
  expect(last?.data[0]).toHaveLength(3);
});

test("SWR-CON-027 a pause holds the plots and not the robot", () => {
  const { rerender } = render(<Plots axes={axes} trace={trace} />);
  fireEvent.click(screen.getByRole("button", { name: "Pause" }));
  take(3);
  rerender(<Plots axes={axes} trace={trace} />);
  frame();
  expect(present().at(-1)?.data[0]).toHaveLength(2);
  expect(readings()[0]).toMatch(/^At the pause; .*position 2\.00 mm/);
  fireEvent.click(screen.getByRole("button", { name: "Go on" }));
  frame();
  expect(present().at(-1)?.data[0]).toHaveLength(3);
  expect(readings()[0]).toMatch(/^Now; .*position 3\.00 mm/);
});

test("SWR-CON-027 the cursor reads all plots, by the pointer", () => {
  render(<Plots axes={axes} trace={trace} />);
  const [plot] = present();
  const data = [[-0.05, 0]];
  act(() => plot?.hooks.setCursor[0]?.({ cursor: { idx: 0 }, data }));
  expect(readings()[0]).toMatch(/^0\.05 s before; .*position 1\.00 mm/);
  act(() => plot?.hooks.setCursor[0]?.({ cursor: { idx: null }, data }));
  expect(readings()[0]).toMatch(/^Now; .*position 2\.00 mm/);
});

test("SWR-CON-027 the cursor reads all plots, by keys", () => {
  render(<Plots axes={axes} trace={trace} />);
  fireEvent.change(screen.getByLabelText(/^Cursor/), {
    target: { value: "-0.05" },
  });
  expect(readings()[0]).toMatch(/^0\.05 s before; .*position 1\.00 mm/);
  expect(present().map(({ pointed }) => pointed)).toEqual([
    [-0.05],
    [-0.05],
    [-0.05],
  ]);
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
