// SPDX-License-Identifier: Apache-2.0
// Rule under test: a robot's file draws its body where the core has its needle. Poses are those of the golden vectors
// N07 (core/robot/neuro/test/golden_neuro.h) and P13 (core/robot/prostate/test/golden_prostate.h).
import { drawings } from "@drawings";
import { expect, test } from "vitest";
import type { Point } from "./scene";

function drawn(robot: string, values: Record<string, number>) {
  const shape = drawings[robot]!.shape((name) => values[name] ?? NaN);
  const points = (part: string) =>
    shape.parts.find(({ name }) => name === part)!.points;
  return { ...shape, points };
}

function along(origin: Point, direction: Point, length: number): Point {
  return origin.map((value, i) => value + length * direction[i]!) as never;
}

function distance(one: Point, other: Point): number {
  return Math.hypot(...one.map((value, i) => value - other[i]!));
}

test("SWR-CON-029 the NeuroRobot's arm ends where its needle turns", () => {
  const { points, rear, tip } = drawn("neuro", {
    head: -20,
    feet: 0,
    lateral: -25,
    insertion: 10,
    robot_to_treatment_mm: 41,
    treatment_to_tip_mm: 10,
  });
  const direction: Point = [-0.603911897563, -0.609618289415, -0.513474401692];
  const treatment: Point = [6.30410579761, 209.221646695, 73.9496996364];
  const robotToRcm = 72.5;
  const rcm = along(treatment, direction, rear + robotToRcm);
  expect(distance(points("arm").at(-1)!, rcm)).toBeLessThan(1e-6);
  expect(tip).toBe(10);
});

test("SWR-CON-029 the NeuroRobot's side links keep their length", () => {
  const { points } = drawn("neuro", { head: -66, feet: 1 });
  const [feet, left, right, head] = points("linkage");
  expect(distance(feet!, left!)).toBeCloseTo(60, 9);
  expect(distance(left!, right!)).toBeCloseTo(30, 9);
  expect(distance(right!, head!)).toBeCloseTo(60, 9);
});

test("SWR-CON-029 the ProstateRobot's needle begins at its front pivot", () => {
  const { points, rear } = drawn("prostate", {
    front_left: 133.674801523,
    front_right: -145.202696061,
    rear_left: 110.037314915,
    rear_right: -101.941414714,
    insertion: 46.5826978216,
    needle_tip_mm: 259.075,
  });
  const direction: Point = [-0.0532830164726, -0.160315426299, 0.985626645463];
  const tip: Point = [
    -22.0503114169,
    107.190534312 - 167.4,
    301.264371364 - 239.71,
  ];
  const [, rearPivot, frontPivot] = points("carrier");
  const toRear = -distance(rearPivot!, frontPivot!);
  const front = along(tip, direction, rear);
  expect(distance(frontPivot!, front)).toBeLessThan(1e-6);
  expect(distance(rearPivot!, along(front, direction, toRear))).toBeLessThan(
    1e-6,
  );
});

test("SWR-CON-030 what rests on an unknown axis has no place", () => {
  const { points } = drawn("neuro", { head: 0, feet: 0 });
  expect(points("rail").flat().every(Number.isFinite)).toBe(true);
  expect(points("linkage").flat().every(Number.isFinite)).toBe(true);
  expect(points("arm").at(-1)).toContainEqual(NaN);
});
