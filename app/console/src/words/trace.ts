// SPDX-License-Identifier: Apache-2.0
import type { Axis, RobotState } from "@interface";
import { STALE_MS } from "../state/freshness";
import { isKnown } from "../state/trust";

export const TRACE_S = 30;
const US_PER_S = 1e6;

/** Quantities of an axis, in this order. */
export const quantities = [
  "setpoint",
  "position",
  "speed",
  "output",
  "goal",
] as const;
export type Quantity = (typeof quantities)[number];

type Values = Readonly<Record<Quantity, number>> & {
  /** Its positions are those of the robot. */
  readonly isKnown: boolean;
};

interface Row {
  /** Time of control since the first row. */
  timeS: number;
  /** By axis; null: for a while nothing came. */
  axes: ReadonlyMap<string, Values> | null;
}

function valuesOf(axis: Axis): Values {
  const { setpoint, position, speed_per_s: speed } = axis;
  const { output_percent: output, target } = axis;
  const numbers = { setpoint, position, speed, output, goal: target };
  return { ...numbers, isKnown: isKnown(axis) };
}

/**
 * The last 30 s of every axis by the time of control, in the memory of the page and outside of React.
 *
 * @satisfies SWR-CON-027
 */
export class Trace {
  /** Another one with each change. */
  revision = 0;
  private rows: Row[] = [];
  private bootId: string | null = null;
  private timeUs = 0;
  private takenMs = 0;
  private readonly spanS: number;

  /** `spanS`: what is older is forgotten. */
  constructor(spanS = TRACE_S) {
    this.spanS = spanS;
  }

  get length(): number {
    return this.rows.length;
  }

  /** `nowMs`: when it came. */
  take({ status, motors }: RobotState, nowMs: number): void {
    const last = this.rows.at(-1);
    // Its counter wraps.
    const wayS = ((motors.time_us - this.timeUs) >>> 0) / US_PER_S;
    if (status.boot_id !== this.bootId || last === undefined) {
      this.rows = [];
      this.bootId = status.boot_id;
    } else if (wayS === 0) {
      return; // Control stands still.
    } else if (nowMs - this.takenMs > STALE_MS) {
      this.rows.push({ timeS: last.timeS + wayS / 2, axes: null });
    }
    this.timeUs = motors.time_us;
    this.takenMs = nowMs;
    const timeS = this.rows.length === 0 ? 0 : (last?.timeS ?? 0) + wayS;
    const axes = new Map(motors.axes.map((one) => [one.name, valuesOf(one)]));
    this.rows.push({ timeS, axes });
    this.forget(timeS - this.spanS);
    this.revision += 1;
  }

  /** Nothing is known until the next one that is taken. */
  lose(): void {
    this.takenMs = -Infinity;
  }

  /** As it is now, for who looks at it while the other goes on. */
  copy(): Trace {
    const copy = new Trace();
    copy.rows = [...this.rows];
    copy.revision = this.revision;
    return copy;
  }

  /** Its rows that were there, and not yet forgotten, after its first so many rows. */
  until(length: number): Trace {
    const past = new Trace();
    past.rows = this.rows.slice(0, length);
    past.forget(past.endS() - TRACE_S);
    past.revision = length;
    return past;
  }

  /** Seconds before the last row, at most 0. */
  times(): number[] {
    const end = this.endS();
    return this.rows.map((row) => row.timeS - end);
  }

  /** Null where there is a gap. A position that was counted before the axis was homed, or lost since, is none either. */
  column(axis: string, quantity: Quantity): (number | null)[] {
    const isKnownNow = this.rows.at(-1)?.axes?.get(axis)?.isKnown;
    const isPlace = quantity !== "speed" && quantity !== "output";
    return this.rows.map((row) => {
      const values = row.axes?.get(axis);
      const isOther = isPlace && values?.isKnown !== isKnownNow;
      return values === undefined || isOther ? null : values[quantity];
    });
  }

  /** Values `agoS` seconds before the last row, or nearest to that; null in a gap. */
  at(axis: string, agoS: number): (Values & { agoS: number }) | null {
    const end = this.endS();
    const distance = (row: Row) => Math.abs(end - row.timeS - agoS);
    const nearest = this.rows.reduce<Row | null>(
      (best, row) =>
        best === null || distance(row) <= distance(best) ? row : best,
      null,
    );
    const values = nearest?.axes?.get(axis);
    return nearest === null || values === undefined
      ? null
      : { ...values, agoS: end - nearest.timeS };
  }

  /** With a line of names and units; what was not received has no row. */
  csv(axes: readonly Pick<Axis, "name" | "unit">[]): string {
    const names = axes.flatMap(({ name, unit }) => [
      `${name} set-point ${unit}`,
      `${name} position ${unit}`,
      `${name} speed ${unit}/s`,
      `${name} output %`,
      `${name} goal ${unit}`,
    ]);
    const lines = this.rows.flatMap(({ timeS, axes: values }) => {
      if (values === null) {
        return [];
      }
      const cells = axes.flatMap(({ name }) =>
        quantities.map((one) => String(values.get(name)?.[one] ?? "")),
      );
      return [[timeS.toFixed(3), ...cells].join(",")];
    });
    return [["time s", ...names].join(","), ...lines, ""].join("\n");
  }

  private endS(): number {
    return this.rows.at(-1)?.timeS ?? 0;
  }

  private forget(beforeS: number): void {
    const kept = this.rows.findIndex((row) => row.timeS >= beforeS);
    this.rows.splice(0, kept);
  }
}
