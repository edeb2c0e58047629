// SPDX-License-Identifier: Apache-2.0
// Drawing of the robot, in one frame: the scanner's where the robot is registered, its z-frame's otherwise.
import { drawings, type RobotDrawing } from "@drawings";
import type { Robot, RobotState } from "@interface";
import { originOf } from "../words/format";

export type Point = readonly [number, number, number];

export interface Line {
  name: string;
  points: readonly Point[];
}

export interface DrawnNeedle {
  treatment: Point;
  /** Its ends; null while its length is unknown. */
  rear: Point | null;
  tip: Point | null;
  /** In degrees, from where the target's needle points; null without a target. */
  angle: number | null;
}

export interface Scene {
  /** The three axes by name. */
  axes: readonly [string, string, string];
  isRegistered: boolean;
  /** The z-frame's origin, and a point on each of its axes. */
  frame: readonly Point[];
  parts: readonly Line[];
  /** Parts of which it is not known where they are. */
  missing: readonly string[];
  needle: DrawnNeedle | null;
  entry: Point | null;
  target: Point | null;
  /** Where the body may come, so that the room for it is there before it is. */
  room: readonly Point[];
}

const FRAME_MM = 30;
const FRAME: readonly Point[] = [
  [0, 0, 0],
  [FRAME_MM, 0, 0],
  [0, FRAME_MM, 0],
  [0, 0, FRAME_MM],
];
const SURE: readonly string[] = ["taken", "verified"];

function toPoint([x = NaN, y = NaN, z = NaN]: readonly number[]): Point {
  return [x, y, z];
}

/** The direction in which the needle points; matrices are by rows. */
function directionOf(matrix: readonly number[]): Point {
  return toPoint([2, 6, 10].map((index) => matrix[index] ?? NaN));
}

function place(matrix: readonly number[] | null, point: Point): Point {
  if (matrix === null) {
    return point;
  }
  const row = (from: number) =>
    point.reduce(
      (sum, value, index) => sum + value * (matrix[from + index] ?? NaN),
      matrix[from + 3] ?? NaN,
    );
  return [row(0), row(4), row(8)];
}

function isKnown(point: Point): boolean {
  return point.every(Number.isFinite);
}

function angleBetween(one: Point, other: Point): number {
  const dot = one.reduce((sum, value, i) => sum + value * (other[i] ?? NaN), 0);
  const cross = Math.hypot(
    one[1] * other[2] - one[2] * other[1],
    one[2] * other[0] - one[0] * other[2],
    one[0] * other[1] - one[1] * other[0],
  );
  return (Math.atan2(cross, dot) * 180) / Math.PI;
}

/** Where an axis stands, or how long a length of the probe is, as far as that is known. */
function lookUp({ motors, targeting }: RobotState, name: string): number {
  const axis = motors.axes.find((one) => one.name === name);
  if (axis !== undefined) {
    return SURE.includes(axis.reference) ? axis.position : NaN;
  }
  const length = targeting.probe.find((one) => `${one.name}_mm` === name);
  return length?.length_mm ?? NaN;
}

/** That of the file which the robot is of. Null: this page has none. */
export function drawingOf(robot: Robot | null): RobotDrawing | null {
  const drawing = robot === null ? undefined : drawings[robot.name];
  return drawing?.checksum === robot?.checksum ? (drawing ?? null) : null;
}

/** At the least, the most and in the middle of all its axes. */
function roomOf({ motors }: RobotState, drawing: RobotDrawing): Point[] {
  const at = (share: number) => (name: string) => {
    const axis = motors.axes.find((one) => one.name === name);
    return axis === undefined
      ? NaN
      : axis.minimum + share * (axis.maximum - axis.minimum);
  };
  return [0, 0.5, 1]
    .flatMap((share) => drawing.shape(at(share)).parts)
    .flatMap(({ points }) => points)
    .filter(isKnown);
}

function needleOf(
  pose: readonly number[] | null,
  ends: { rear: number; tip: number } | undefined,
  target: readonly number[] | null,
): DrawnNeedle | null {
  if (pose === null) {
    return null;
  }
  const treatment = toPoint(originOf(pose));
  const direction = directionOf(pose);
  const along = (length = NaN) => {
    const end = toPoint(treatment.map((v, i) => v + length * direction[i]!));
    return isKnown(end) ? end : null;
  };
  return {
    treatment,
    rear: along(ends?.rear),
    tip: along(ends?.tip),
    angle:
      target === null ? null : angleBetween(direction, directionOf(target)),
  };
}

/** `drawing`: null where only the needle can be drawn. */
export function sceneOf(
  robot: RobotState,
  drawing: RobotDrawing | null,
): Scene {
  const { registration, scanner_treatment, zframe_treatment, ...plan } =
    robot.targeting;
  const isRegistered = registration !== null;
  const shape = drawing?.shape((name) => lookUp(robot, name));
  const lines = shape?.parts ?? [];
  const isDrawn = (line: Line) => line.points.every(isKnown);
  const pose = isRegistered ? scanner_treatment : zframe_treatment;
  const target = isRegistered ? plan.target : null;
  return {
    axes: isRegistered ? ["R", "A", "S"] : ["x", "y", "z"],
    isRegistered,
    frame: FRAME.map((point) => place(registration, point)),
    parts: lines.filter(isDrawn).map(({ name, points }) => ({
      name,
      points: points.map((point) => place(registration, point)),
    })),
    missing: lines.filter((line) => !isDrawn(line)).map(({ name }) => name),
    needle: needleOf(pose, shape, target),
    entry: isRegistered && plan.entry_mm ? toPoint(plan.entry_mm) : null,
    target: target === null ? null : toPoint(originOf(target)),
    room: (drawing === null ? [] : roomOf(robot, drawing)).map((point) =>
      place(registration, point),
    ),
  };
}

/** All that is drawn, and may be. */
export function pointsOf(scene: Scene): Point[] {
  const { needle } = scene;
  return [
    ...scene.frame,
    ...scene.room,
    ...scene.parts.flatMap(({ points }) => points),
    ...[needle?.rear, needle?.treatment, needle?.tip],
    ...[scene.entry, scene.target],
  ].filter((point): point is Point => point !== null && point !== undefined);
}
