// SPDX-License-Identifier: Apache-2.0
// Rule under test: each robot is drawn to scale from its own file, where the core has its needle, and nothing is drawn
// of which it is not known where it is.
import { act, cleanup, render, screen, within } from "@testing-library/react";
import { drawings } from "@drawings";
import { afterEach, expect, test, vi } from "vitest";
import type { RobotState, Targeting } from "@interface";
import { RETRY_MS } from "../../state/answer";
import { Page } from "../../state/page";
import { makeAxis, makeRobot } from "../../testing/robot";
import { plainRobot } from "../../testing/commander";
import { Drawing } from "./Drawing";

const axes = ["head", "feet", "lateral", "insertion"];
/** Pose of the NeuroRobot at home: N01 of core/robot/neuro/test/golden_neuro.h. */
const home = [-1, 0, 0, 18.32, 0, 0, -1, 209.89, 0, -1, 0, 72.91, 0, 0, 0, 1];
const probe = { treatment_to_tip: 10, robot_to_treatment: 41 };
/** The scanner's axes are the z-frame's, 100 mm away along S. */
const shifted = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 100, 0, 0, 0, 1];

function makeNeuro(change: Partial<Targeting> = {}): RobotState {
  const robot = makeRobot(
    {},
    axes.map((name) => makeAxis(name, { position: 0 })),
  );
  const lengths = Object.entries(probe).map(([name, length_mm]) => ({
    name,
    length_mm,
    minimum_mm: 0,
    maximum_mm: 100,
  }));
  return {
    ...robot,
    targeting: {
      ...robot.targeting,
      zframe_treatment: home,
      probe: lengths,
      ...change,
    },
  };
}

async function show(
  robot: RobotState,
  checksum = drawings.neuro?.checksum,
): Promise<void> {
  const answer = JSON.stringify({ ...plainRobot, checksum });
  vi.stubGlobal("fetch", () => Promise.resolve(new Response(answer)));
  const page = new Page(() => null);
  render(<Drawing robot={robot} page={page} />);
  await act(() => Promise.resolve());
}

function said(term: string): string | null | undefined {
  return screen.getByText(term).nextElementSibling?.textContent;
}

function view(title: string): HTMLElement {
  return screen.getByRole("img", { name: new RegExp(title) });
}

function part(title: string, name: string): number[] {
  const line = within(view(title)).getByText(name).parentElement!;
  const points = line.querySelector("polyline")!.getAttribute("points")!;
  return points.split(" ").map(Number);
}

function mark(title: string, name: string): number[] | null {
  const found = view(title).querySelector(`[data-mark="${name}"]`);
  const text = found?.getAttribute("transform");
  return text ? text.match(/-?[\d.]+/g)!.map(Number) : null;
}

function scaleOf(title: string): number {
  const bar = view(title).querySelector<SVGElement>("[data-mm]")!;
  const [, pixels] = /h([\d.]+)/.exec(
    bar.querySelector("path")!.getAttribute("d")!,
  )!;
  return Number(pixels) / Number(bar.dataset.mm);
}

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

test("SWR-CON-029 both views have one scale, and a bar that says it", async () => {
  await show(makeNeuro());
  expect(scaleOf("Side view")).toBe(scaleOf("Top view"));
  const [x1, y1, x2, y2] = part("Side view", "linkage");
  const link = Math.hypot(x2! - x1!, y2! - y1!);
  expect(link / scaleOf("Side view")).toBeCloseTo(60, 6);
});

test("SWR-CON-029 without a registration the axes are the z-frame's, and it is said", async () => {
  await show(makeNeuro());
  expect(said("Coordinates")).toBe("z-frame of the robot, mm; not registered");
  within(view("Side view")).getByText("z");
  expect(said("Treatment point ◆")).toBe("18.32, 209.89, 72.91");
  expect(said("Needle tip")).toBe("18.32, 199.89, 72.91");
});

test("SWR-CON-029 in the scanner's coordinates points, distance and angle are shown", async () => {
  const treatment = home.with(11, 172.91);
  const tilted = Math.SQRT1_2;
  const target = [
    [-1, 0, 0, 18.32],
    [0, -tilted, -tilted, 199.89],
    [0, -tilted, tilted, 172.91],
    [0, 0, 0, 1],
  ].flat();
  await show(
    makeNeuro({
      registration: shifted,
      scanner_treatment: treatment,
      target,
      entry_mm: [18.32, 240, 172.91],
      distance_mm: 10,
    }),
  );
  expect(said("Coordinates")).toBe("scanner: R, A, S in mm");
  within(view("Side view")).getByText("S");
  within(view("Top view")).getByText("R");
  expect(said("Treatment point ◆")).toBe("18.32, 209.89, 172.91");
  expect(said("Target ⊕")).toBe("18.32, 199.89, 172.91");
  expect(said("Entry point □")).toBe("18.32, 240.00, 172.91");
  expect(said("Treatment point to target")).toBe("10.00 mm");
  expect(said("Angle to the target’s line")).toBe("45.0°");
  const [, from] = mark("Side view", "treatment")!;
  const [, to] = mark("Side view", "target")!;
  expect((to! - from!) / scaleOf("Side view")).toBeCloseTo(10, 6);
});

test("SWR-CON-030 a needle that is not known is not drawn, and that is said", async () => {
  await show(makeNeuro({ zframe_treatment: null }));
  expect(mark("Side view", "treatment")).toBeNull();
  expect(said("Treatment point ◆")).toBe("unknown until all axes are homed");
  expect(said("Needle tip")).toBe("unknown until all axes are homed");
});

test("SWR-CON-030 of the body what rests on an axis that is not homed is left out by name", async () => {
  const robot = makeNeuro();
  const [head, ...others] = robot.motors.axes;
  const unhomed = { ...head!, reference: "lost" as const };
  const motors = { ...robot.motors, axes: [unhomed, ...others] };
  await show({ ...robot, motors });
  expect(said("Not drawn")).toBe("linkage, arm: an axis is not homed");
  within(view("Side view")).getByText("rail");
  expect(within(view("Side view")).queryByText("arm")).toBeNull();
});

test("SWR-CON-030 points of the scanner are not drawn without a registration", async () => {
  await show(makeNeuro({ entry_mm: [1, 2, 3] }));
  expect(said("Entry point □")).toBe("not drawn without registration");
  expect(mark("Side view", "entry")).toBeNull();
});

test("SWR-CON-060 a lost answer about the robot is asked for again until it is there", async () => {
  vi.useFakeTimers();
  let lost = 2;
  const robot = { ...plainRobot, checksum: drawings.neuro?.checksum };
  vi.stubGlobal("fetch", () =>
    lost-- > 0
      ? Promise.reject(new Error("lost"))
      : Promise.resolve(new Response(JSON.stringify(robot))),
  );
  render(<Drawing robot={makeNeuro()} page={new Page(() => null)} />);
  await act(() => vi.advanceTimersByTimeAsync(0));
  expect(said("Not drawn")).toBe("the body: not known yet which robot it is");
  await act(() => vi.advanceTimersByTimeAsync(2 * RETRY_MS));
  expect(said("Not drawn")).toBe("–");
  const asked = lost;
  await act(() => vi.advanceTimersByTimeAsync(2 * RETRY_MS));
  expect(lost).toBe(asked);
  vi.useRealTimers();
});

test("SWR-CON-030 a body of another file is not drawn", async () => {
  await show(makeNeuro(), "00000000");
  expect(said("Not drawn")).toMatch(/no drawing of this robot's file/);
  expect(within(view("Side view")).queryByText("rail")).toBeNull();
  expect(mark("Side view", "treatment")).not.toBeNull();
  expect(said("Needle tip")).toBe("unknown");
});
