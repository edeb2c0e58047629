// SPDX-License-Identifier: Apache-2.0
// Rule under test: hand and needle are drawn together over time and over depth while they are believed, read at a cursor, and
// saved.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Force, LogEntry } from "@interface";
import { saveText } from "../../words/download";
import { makeAxis, makeEntry, makeForce, makeRobot } from "../../testing/robot";
import { Trace } from "../../words/trace";
import { ForcePlots } from "./ForcePlots";

vi.mock("../../words/download", () => ({ saveText: vi.fn() }));

const NOT_ZEROED = { name: "NOT_ZEROED", text: "It is not zeroed." } as const;
const [OVER_TIME, OVER_DEPTH, DEPTH] = [0, 1, 2];
const { needle } = makeRobot().status;
let trace: Trace;
let timeUs: number;

/** Forces in mN; null: doubtful. */
function take(depth: number, hand: number | null, onNeedle: number): void {
  const axis = makeAxis("insertion", {
    position: depth,
    reference: "verified",
  });
  const forces: Force[] = [
    makeForce({
      force_mn: hand ?? 9999,
      doubts: hand === null ? [NOT_ZEROED] : [],
    }),
    makeForce({ channel: "NEEDLE", force_mn: onNeedle }),
  ];
  const robot = makeRobot({ forces }, [axis]);
  timeUs += 50_000;
  robot.motors.time_us = timeUs;
  trace.take(robot, timeUs / 1000);
}

/** Points of the curve in that plot, in the stretches between its gaps. */
function drawn(plot: number, look: string): [number, number][][] {
  const svg = document.querySelectorAll(".plot")[plot];
  const curve = svg?.querySelector(`.plot-line-${look}`);
  return (curve?.getAttribute("d") ?? "")
    .replaceAll("h0", "")
    .split("M")
    .slice(1)
    .map((stretch) =>
      stretch
        .split("L")
        .map((point) => point.split(",").map(Number) as [number, number]),
    );
}

function reading(): string {
  const spans = document.querySelectorAll(".plot-reading span");
  return [...spans].map(({ textContent }) => textContent).join("; ");
}

function show() {
  return render(<ForcePlots needle={needle} trace={trace} />);
}

beforeEach(() => {
  trace = new Trace();
  timeUs = 0;
  take(10, 1000, 500);
  take(20, 3000, 1500);
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

test("SWR-CON-610 both forces are drawn in one scale over time, and the depth over the same time", () => {
  show();
  const [[first, last] = []] = drawn(OVER_TIME, "hand");
  const [[low, high] = []] = drawn(OVER_TIME, "needle");
  const [[shallow, deep] = []] = drawn(DEPTH, "depth");
  // 1 and 3 N of the hand, 0.5 and 1.5 N of the needle.
  const scale = (first![1] - last![1]) / 2;
  expect((low![1] - high![1]) / scale).toBeCloseTo(1, 1);
  expect((low![1] - first![1]) / scale).toBeCloseTo(0.5, 1);
  expect(deep![1]).toBeLessThan(shallow![1]);
  expect([shallow![0], deep![0]]).toEqual([first![0], last![0]]);
});

test("SWR-CON-610 both forces are drawn over the depth", () => {
  take(15, 2000, 800);
  show();
  for (const look of ["hand", "needle"]) {
    const [[ten, twenty, fifteen] = []] = drawn(OVER_DEPTH, look);
    expect(fifteen![0]).toBeCloseTo((ten![0] + twenty![0]) / 2, 0);
    expect(fifteen![1]).toBeLessThan(ten![1]);
    expect(fifteen![1]).toBeGreaterThan(twenty![1]);
  }
});

test("SWR-CON-610 they are numbers at the end, and at a cursor in all plots", () => {
  show();
  expect(reading()).toBe(
    "Now; hand 3.00 N; needle 1.50 N; position of the axis 20.00 mm",
  );
  fireEvent.change(screen.getByLabelText(/^Cursor/), {
    target: { value: "-0.05" },
  });
  expect(reading()).toBe(
    "0.05 s before; hand 1.00 N; needle 0.50 N; position of the axis 10.00 mm",
  );
  const cursors = [...document.querySelectorAll(".plot")].map((plot) =>
    Number(
      /^M([\d.]+),/.exec(
        plot.querySelector(".plot-cursor")?.getAttribute("d") ?? "",
      )?.[1],
    ),
  );
  expect(cursors[OVER_TIME]).toBe(cursors[DEPTH]);
  expect(cursors[OVER_DEPTH]).toBe(drawn(OVER_DEPTH, "hand")[0]?.[0]?.[0]);
});

test("SWR-CON-610 a pause holds them", () => {
  const { rerender } = show();
  fireEvent.click(screen.getByRole("button", { name: "Pause" }));
  take(21, 0, 0);
  rerender(<ForcePlots needle={needle} trace={trace} />);
  expect(drawn(OVER_TIME, "hand")[0]).toHaveLength(2);
  expect(reading()).toMatch(/^At the pause; hand 3\.00 N/);
});

test("SWR-CON-610 they are saved where depth and force of the needle are known", () => {
  take(21, null, 1600);
  show();
  fireEvent.click(screen.getByRole("button", { name: "Save as CSV" }));
  const [name, , text] = vi.mocked(saveText).mock.calls.at(-1) ?? [];
  expect([name, text]).toEqual([
    "force.csv",
    "time_ms,position_mm,force_n,hand_n\n0,10,0.5,1\n50,20,1.5,3\n100,21,1.6,\n",
  ]);
});

/** The newest one first; that at 1 mm is of another insertion. */
const log = [
  ["MEMBRANE_UNEXPECTED", 8_000_000],
  ["MEMBRANE_FOUND", 6_000_000],
  ["MEMBRANE_UNEXPECTED", 2_500_000],
  ["MEMBRANE_UNEXPECTED", 1_000_000],
].map(([name, value]) =>
  makeEntry(1, { name: name as LogEntry["name"], value: Number(value) }),
);

/** The needle is at `depth`, which is so far `below` the entry point. */
function takeInsertion(
  depth: number,
  below: number | null,
  z = 0,
  unexpected = 0,
): void {
  const axis = makeAxis("insertion", { position: depth });
  const robot = makeRobot({ forces: [makeForce({})] }, [axis]);
  robot.targeting.entry_mm = [0, 0, z];
  robot.targeting.membranes = {
    expected: [
      { depth_mm: 4, found_mm: 6, state: "FOUND" },
      { depth_mm: 11, found_mm: null, state: "MISSED" },
      { depth_mm: 16, found_mm: null, state: "AHEAD" },
    ],
    left: 1,
    unexpected,
    sight: "OFF",
    says: "",
    depth_mm: below,
    least_fall_mn: null,
  };
  timeUs += 50_000;
  robot.motors.time_us = timeUs;
  trace.take(robot, timeUs / 1000, log);
}

function titles(): (string | null)[] {
  const captions = document.querySelectorAll("figcaption");
  return [...captions].map(({ firstChild }) => firstChild?.textContent ?? null);
}

/** Words under the plot. */
function ticks(plot: number): string[] {
  const svg = document.querySelectorAll(".plot")[plot];
  const found = svg?.querySelectorAll('text[text-anchor="middle"]') ?? [];
  return [...found].map(({ textContent }) => textContent ?? "");
}

test("SWR-CON-750 once the entry point is known, each depth counts from there and says so", () => {
  const { rerender } = show();
  expect(titles()).toEqual([
    "Force over time, N",
    "Force over the position of the axis, N",
    "The position of the axis over time, mm",
  ]);
  expect(ticks(OVER_DEPTH)).toContain("20 mm");
  // It is at 14 mm of the axis, and was so for all of the curve.
  takeInsertion(18.2, 4.2);
  rerender(<ForcePlots needle={needle} trace={trace} />);
  expect(titles()).toEqual([
    "Force over time, N",
    "Force over the depth below the entry point, N",
    "The depth below the entry point over time, mm",
  ]);
  expect(ticks(OVER_DEPTH)).toContain("-5 mm");
  expect(ticks(OVER_DEPTH)).not.toContain("20 mm");
  expect(reading()).toContain("depth below the entry point 4.20 mm");
  const cursor = screen.getByLabelText(/^Cursor/);
  fireEvent.change(cursor, { target: { value: "-0.05" } });
  expect(reading()).toContain("depth below the entry point 6.00 mm");
  fireEvent.click(screen.getByRole("button", { name: "Save as CSV" }));
  const [, , text] = vi.mocked(saveText).mock.calls.at(-1) ?? [];
  expect(text).toMatch(
    /^time_ms,depth_mm,force_n,hand_n\n0,-4,0\.5,1\n50,6,1\.5,3\n$/,
  );
});

/** Places across of the marks, by their look. */
function marks(): Record<string, number> {
  const found = document.querySelectorAll(".plot .plot-mark");
  const places = [...found].map((mark): [string, number] => [
    /plot-mark-(\w+)/.exec(mark.getAttribute("class") ?? "")?.[1] ?? "",
    Number(/^M([\d.]+),/.exec(mark.getAttribute("d") ?? "")?.[1]),
  ]);
  return Object.fromEntries(places);
}

test("SWR-CON-700 membranes stand in the force over depth, one that was found where it was punctured", () => {
  takeInsertion(18, 4);
  const { rerender } = show();
  // The entry point is at 14 mm of the axis.
  const [[ten, twenty] = []] = drawn(OVER_DEPTH, "needle");
  const perMm = (twenty![0] - ten![0]) / 10;
  const { found, missed, ahead } = marks();
  expect(found).toBeCloseTo(twenty![0], 0);
  expect(missed! - twenty![0]).toBeCloseTo(5 * perMm, 0);
  expect(ahead! - twenty![0]).toBeCloseTo(10 * perMm, 0);
  expect(document.querySelector(".plots-kinds")?.textContent).toContain(
    "membrane foundmembrane missedmembrane ahead",
  );
  takeInsertion(10, null);
  rerender(<ForcePlots needle={needle} trace={trace} />);
  expect(Object.keys(marks())).toHaveLength(3);
});

test("SWR-CON-754 punctures that were not expected stand in the force over depth", () => {
  takeInsertion(24, 10, 0, 2);
  show();
  const curve = drawn(OVER_DEPTH, "needle")[0]!;
  const perMm = (curve[1]![0] - curve[0]![0]) / 10;
  const places = [...document.querySelectorAll(".plot .plot-mark-unexpected")]
    .map((mark) => /^M([\d.]+),/.exec(mark.getAttribute("d") ?? "")?.[1])
    .filter((place) => place !== undefined);
  // 20 mm of the axis are 6 mm below the entry point.
  expect(
    places.map((place) => (Number(place) - curve[1]![0]) / perMm + 6),
  ).toEqual([expect.closeTo(8, 1), expect.closeTo(2.5, 1)]);
  expect(document.querySelector(".plots-kinds")?.textContent).toContain(
    "unexpected puncture",
  );
});

test("SWR-CON-700 no membrane stands where the entry point is not known", () => {
  takeInsertion(18, null);
  const { rerender } = show();
  expect(marks()).toEqual({});
  takeInsertion(18, 4);
  takeInsertion(18, null, 1);
  rerender(<ForcePlots needle={needle} trace={trace} />);
  expect(marks()).toEqual({});
  takeInsertion(18, 4);
  timeUs += 5_000_000;
  takeInsertion(18, null);
  rerender(<ForcePlots needle={needle} trace={trace} />);
  expect(marks()).toEqual({});
});

test("SWR-CON-611 a doubtful force is a gap, and no number", () => {
  take(21, null, 1600);
  take(22, 2000, 1700);
  const { rerender } = show();
  expect(drawn(OVER_TIME, "hand").map(({ length }) => length)).toEqual([2, 1]);
  expect(drawn(OVER_DEPTH, "hand").map(({ length }) => length)).toEqual([2, 1]);
  expect(drawn(OVER_TIME, "needle").map(({ length }) => length)).toEqual([4]);
  take(23, null, 1800);
  rerender(<ForcePlots needle={needle} trace={trace} />);
  expect(reading()).toBe(
    "Now; hand doubtful; needle 1.80 N; position of the axis 23.00 mm",
  );
});

test("SWR-CON-611 where no data came there is a gap", () => {
  timeUs += 5_000_000;
  take(21, 1000, 500);
  show();
  for (const plot of [OVER_TIME, OVER_DEPTH]) {
    expect(drawn(plot, "needle").map(({ length }) => length)).toEqual([2, 1]);
  }
});
