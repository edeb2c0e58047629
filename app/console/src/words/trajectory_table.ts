// SPDX-License-Identifier: Apache-2.0
// Preview of a table of a trajectory, before it is sent. The server judges whether it is right.
import type { GraphPoint } from "../parts/drawn/Graph";

export interface AxisWay {
  axis: string;
  unit: string;
  /** Time in seconds, position in the unit. */
  points: GraphPoint[];
}

export interface TrajectoryTable {
  rows: number;
  durationS: number;
  ways: AxisWay[];
}

const TIME = /^time (s|ms)$/;
const POSITION = /^(\w+) (mm|deg|ticks)$/;

/** Null where there is nothing to be seen: no rows, no time, or no axis. */
export function readTrajectory(text: string): TrajectoryTable | null {
  const [head = "", ...lines] = text.split(/\r?\n/);
  const names = head.split(",").map((name) => name.trim());
  const timeColumn = names.findIndex((name) => TIME.test(name));
  const perSecond = names[timeColumn] === "time ms" ? 1000 : 1;
  const end = lines.indexOf("");
  const rows = (end < 0 ? lines : lines.slice(0, end)).map((line) =>
    line.split(",").map(Number),
  );
  const times = rows.map((row) => (row[timeColumn] ?? Number.NaN) / perSecond);
  const ways = names.flatMap((name, column) => {
    const [, axis, unit] = POSITION.exec(name) ?? [];
    const points = rows.map(
      (row, index) =>
        [times[index] ?? Number.NaN, row[column] ?? Number.NaN] as const,
    );
    return axis === undefined || unit === undefined
      ? []
      : [{ axis, unit, points: points.filter((one) => one.every(isFinite)) }];
  });
  const durationS = (times.at(-1) ?? Number.NaN) - (times[0] ?? Number.NaN);
  return rows.length > 0 && ways.length > 0 && Number.isFinite(durationS)
    ? { rows: rows.length, durationS, ways }
    : null;
}

/** The line that a refusal names, "line 3"; null if it names none of the text. */
export function lineOf(text: string, pointer: string | undefined) {
  const number = Number(/^line (\d+)$/.exec(pointer ?? "")?.[1] ?? Number.NaN);
  return text.split(/\r?\n/)[number - 1] ?? null;
}
