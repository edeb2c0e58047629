// SPDX-License-Identifier: Apache-2.0
import type { Axis, Force, LogEntry, Membrane, RobotState } from "@interface";
import { STALE_MS } from "../state/freshness";
import { isKnown } from "../state/trust";

export const TRACE_S = 30;
const US_PER_S = 1e6;
const NM_PER_MM = 1e6;
/** A vibration begins in the cycle after its puncture. */
const SAME_PUNCTURE_MM = 0.05;

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
  forces: Newtons;
  line: Line;
}

/** The way of the needle through entry point and target. */
interface Line {
  key: string;
  /** Position of the needle's axis with the needle at the entry point; null until an insertion by hand has shown it. */
  entry: number | null;
  expected: readonly Membrane[];
  /** Depths of punctures that were none of them. */
  unexpected: readonly number[];
  /** Depths of the punctures that a vibration has answered. */
  vibrations: readonly number[];
}

type Log = readonly Pick<LogEntry, "name" | "value">[];

/** A line across the force over depth. */
export interface DepthMark {
  state: Membrane["state"] | "UNEXPECTED" | "VIBRATION";
  place: number;
}

function depthsOf(event: LogEntry["name"], log: Log): number[] {
  return log
    .filter(({ name }) => name === event)
    .map(({ value }) => value / NM_PER_MM);
}

/** Depths of the last `count` unexpected punctures, which belong to the present or last insertion by hand. The log has its newest entry first. */
function unexpectedOf(count: number, log: Log): number[] {
  return depthsOf("MEMBRANE_UNEXPECTED", log).slice(0, count);
}

function vibrationsOf(punctures: readonly number[], log: Log): number[] {
  const begun = depthsOf("VIBRATION_BEGUN", log);
  return punctures.filter((puncture) =>
    begun.some((depth) => Math.abs(depth - puncture) < SAME_PUNCTURE_MM),
  );
}

function lineOf(
  { status, motors, targeting }: RobotState,
  log: Log,
  last?: Line,
): Line {
  const { target, entry_mm, membranes, probe, registration } = targeting;
  const key = JSON.stringify([target, entry_mm, probe, registration]);
  const depth = membranes?.depth_mm ?? null;
  const needle = motors.axes.find(({ name }) => name === status.needle.axis);
  const before = last?.key === key ? last.entry : null;
  const entry =
    depth === null || needle === undefined ? before : needle.position - depth;
  const { expected = [] } = membranes ?? {};
  const unexpected = unexpectedOf(membranes?.unexpected ?? 0, log);
  const found = expected.flatMap(({ found_mm }) => found_mm ?? []);
  const vibrations = vibrationsOf([...found, ...unexpected], log);
  return { key, entry, expected, unexpected, vibrations };
}

/** Forces in newton; none of a channel that is doubtful. */
export type Newtons = ReadonlyMap<Force["channel"], number>;

function believed(forces: readonly Force[]): Newtons {
  return new Map(
    forces
      .filter(({ doubts }) => doubts.length === 0)
      .map(({ channel, force_mn }) => [channel, force_mn / 1000]),
  );
}

function valuesOf(axis: Axis): Values {
  const { setpoint, position, speed_per_s: speed } = axis;
  const { output_percent: output, target } = axis;
  const numbers = { setpoint, position, speed, output, goal: target };
  return { ...numbers, isKnown: isKnown(axis) };
}

/**
 * The last 30 s of every axis and force by the time of control, in the memory of the page and outside of React.
 *
 * @satisfies SWR-CON-027
 * @satisfies SWR-CON-611
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

  /** `nowMs`: when it came; `log`: the newest entry first. */
  take(robot: RobotState, nowMs: number, log: Log = []): void {
    const { status, motors } = robot;
    const last = this.rows.at(-1);
    const isGap = nowMs - this.takenMs > STALE_MS;
    // In a gap another plan may have come and gone.
    const line = lineOf(robot, log, isGap ? undefined : last?.line);
    // Its counter wraps.
    const wayS = ((motors.time_us - this.timeUs) >>> 0) / US_PER_S;
    if (status.boot_id !== this.bootId || last === undefined) {
      this.rows = [];
      this.bootId = status.boot_id;
    } else if (wayS === 0) {
      return; // Control stands still.
    } else if (isGap) {
      const timeS = last.timeS + wayS / 2;
      this.rows.push({ timeS, axes: null, forces: new Map(), line });
    }
    this.timeUs = motors.time_us;
    this.takenMs = nowMs;
    const timeS = this.rows.length === 0 ? 0 : (last?.timeS ?? 0) + wayS;
    const axes = new Map(motors.axes.map((one) => [one.name, valuesOf(one)]));
    this.rows.push({ timeS, axes, forces: believed(status.forces), line });
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

  /** Null where there is a gap, and where the force was doubtful. */
  force(channel: Force["channel"]): (number | null)[] {
    return this.rows.map(({ forces }) => forces.get(channel) ?? null);
  }

  /** Whether the depth of the needle below the entry point is known. */
  get hasDepth(): boolean {
    return this.entry !== null;
  }

  /** Depth below the entry point; while that is not known, the position itself. */
  depthOf(position: number): number {
    return Math.round((position - (this.entry ?? 0)) * NM_PER_MM) / NM_PER_MM;
  }

  /** The depths of the needle, one for each kept position of its axis, as `depthOf` computes them. */
  depths(axis: string): (number | null)[] {
    return this.column(axis, "position").map((position) =>
      position === null ? null : this.depthOf(position),
    );
  }

  /**
   * Membranes at depths below the entry point, one that was found where it was punctured, and punctures that were not
   * expected.
   */
  membranes(): DepthMark[] {
    const line = this.rows.at(-1)?.line;
    const { expected = [], unexpected = [], vibrations = [] } = line ?? {};
    const marks: DepthMark[] = [
      ...expected.map(({ state, depth_mm, found_mm }) => ({
        state,
        place: found_mm ?? depth_mm,
      })),
      ...unexpected.map((place) => ({ state: "UNEXPECTED" as const, place })),
      ...vibrations.map((place) => ({ state: "VIBRATION" as const, place })),
    ];
    return this.hasDepth ? marks : [];
  }

  /** Values `agoS` seconds before the last row, or nearest to that; null in a gap. */
  at(
    axis: string,
    agoS: number,
  ): (Values & { agoS: number; forces: Newtons }) | null {
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
      : { ...values, agoS: end - nearest.timeS, forces: nearest.forces };
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

  /** Depth and force of the needle where both were known, and the hand's force beside them. */
  forceCsv(axis: string): string {
    const depths = this.depths(axis);
    const [hand, needle] = [this.force("HAND"), this.force("NEEDLE")];
    const lines = this.rows.flatMap(({ timeS }, index) => {
      const [depth, force] = [depths[index], needle[index]];
      return typeof depth === "number" && typeof force === "number"
        ? [[(timeS * 1000).toFixed(0), depth, force, hand[index] ?? ""].join()]
        : [];
    });
    const name = this.hasDepth ? "depth_mm" : "position_mm";
    return [`time_ms,${name},force_n,hand_n`, ...lines, ""].join("\n");
  }

  private get entry(): number | null {
    return this.rows.at(-1)?.line.entry ?? null;
  }

  private endS(): number {
    return this.rows.at(-1)?.timeS ?? 0;
  }

  private forget(beforeS: number): void {
    const kept = this.rows.findIndex((row) => row.timeS >= beforeS);
    this.rows.splice(0, kept);
  }
}
