// SPDX-License-Identifier: Apache-2.0
// A recording as app/replay/export/motion_json.h has written it, for looking at any of its cycles.
import type { LogEntry, Robot, RobotState } from "@interface";
import { observe, type Seen } from "../words/chart_states";
import { words } from "../words/format";
import { signOf, type SignKind } from "../words/sign";
import type { ConsoleView } from "../state/store";
import { Trace } from "../words/trace";
import { Tape, type Row } from "./tape";

const FORMAT = 2;
/** After so many rows the whole is kept, so that no cycle is far from one that is known. */
const KEPT_ROWS = 500;
const MS_PER_S = 1000;
const CYCLES_PER_S = 1000;

/** The frame that left to a card, by the names of core/card. */
export type Frame = Readonly<Record<string, string | number>>;

/** The content of a cycle. */
interface Reported {
  /** Since the first one. */
  time_s: number;
  state: RobotState;
  /** By slot; null: none left to it. */
  frames: readonly (Frame | null)[];
}

/** Which recording it is, and how its replay went. */
export interface Identity {
  build: string;
  replayed_by: string;
  robot: string;
  checksum: string;
  started: string;
  run: string;
  /** Its first cycle; how many cycles the run has up to its last one. */
  first: number;
  cycles: number;
  /** The run ends with its last cycle. */
  has_run_end: boolean;
  is_whole_run: boolean;
  /** Cycles between the first and the last that it does not have. */
  missing: number;
  replayed: number;
  unreplayed: number;
  cycles_lost: number;
  is_cut_short: boolean;
  is_trusted: boolean;
  /** Empty: there is none. */
  difference: string;
}

export interface RecordingDocument {
  format: number;
  /** Cycles between those in which numbers are given. */
  numbers_each: number;
  robot: Robot;
  rows: readonly Row[];
  events: readonly LogEntry[];
  recording: Identity;
}

/** A cycle as it is shown. */
export interface Moment {
  cycle: number;
  timeS: number;
  robot: RobotState;
  frames: readonly (Frame | null)[];
  seen: Seen;
  /** From this cycle on nothing is missing until then. */
  since: number;
  /** The 30 s until then. */
  trace: Trace;
}

/** From a cycle until before another one it was alike. */
export interface Span {
  from: number;
  to: number;
  kind: string;
  text: string;
}

/** Name of a span of which nothing is known. */
const UNKNOWN = "unknown";

export interface Lanes {
  workphases: readonly Span[];
  signs: readonly Span[];
  reasons: readonly Span[];
}

/** The view that the console would have shown. */
export function viewOf(robot: RobotState): ConsoleView {
  return {
    isConnected: true,
    refusal: null,
    freshness: "live",
    ageMs: 0,
    isOutdated: false,
    robot,
    log: [],
  };
}

/** Spans one after the other. */
class Lane {
  readonly spans: Span[] = [];

  take(cycle: number, kind: string, text: string): void {
    const last = this.spans.at(-1);
    if (last?.kind === kind && last.text === text) {
      return;
    }
    if (last !== undefined) {
      last.to = cycle;
    }
    this.spans.push({ from: cycle, to: cycle, kind, text });
  }

  end(cycle: number): readonly Span[] {
    this.spans.slice(-1).forEach((last) => {
      last.to = cycle;
    });
    return this.spans;
  }
}

const moves: readonly SignKind[] = ["moving", "may"];

/**
 * @satisfies SWR-REPLAY-018
 * @satisfies SWR-REPLAY-021
 */
export class Recording {
  readonly robot: Robot;
  readonly identity: Identity;
  readonly events: readonly LogEntry[];
  readonly numbersEach: number;
  readonly first: number;
  readonly last: number;
  readonly lanes: Lanes;
  /** All of it. */
  readonly trace = new Trace(Infinity);
  private readonly rows: readonly Row[];
  private readonly cycles: number[] = [];
  private readonly kept: Tape[] = [];
  /** By row: the states of the charts, the cycle since which none is missing, and the length of the trace. */
  private readonly seen: Seen[] = [];
  private readonly since: number[] = [];
  private readonly traced: number[] = [];
  /** The cycle with which the trace begins. */
  private tracedFrom: number | null = null;

  constructor(written: RecordingDocument) {
    if (written.format !== FORMAT) {
      throw new Error(`The recording is of format ${written.format}.`);
    }
    this.robot = written.robot;
    this.identity = written.recording;
    this.events = written.events;
    this.numbersEach = written.numbers_each;
    this.rows = written.rows;
    this.lanes = this.readAll();
    this.first = this.cycles[0] ?? 0;
    this.last = this.cycles.at(-1) ?? 0;
  }

  /** None of its cycles is known. */
  get isEmpty(): boolean {
    return this.tracedFrom === null;
  }

  /** The cycle of a place in the trace. */
  cycleOf(timeS: number): number {
    return (this.tracedFrom ?? this.first) + timeS * CYCLES_PER_S;
  }

  /** The last row of the cycle or before it. */
  private rowOf(cycle: number): number {
    let [low, high] = [0, this.cycles.length];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.cycles[middle]! <= cycle) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Null: nothing is known of the cycle. */
  at(cycle: number): Moment | null {
    const row = this.rowOf(cycle);
    const begin = Math.floor(row / KEPT_ROWS);
    const tape = this.kept[begin]!.copy();
    this.rows
      .slice(begin * KEPT_ROWS + 1, row + 1)
      .forEach((one) => tape.take(one));
    const reported = tape.value as Reported | null;
    if (reported === null) {
      return null;
    }
    const { state, frames, time_s } = reported;
    const timeS = time_s + (cycle - tape.counted) / CYCLES_PER_S;
    return {
      cycle,
      timeS,
      robot: { ...state, status: { ...state.status, utc: this.utcOf(timeS) } },
      frames,
      seen: this.seen[row]!,
      since: this.since[row]!,
      trace: this.trace.until(this.traced[row]!),
    };
  }

  private utcOf(timeS: number): string {
    const startedMs = Date.parse(this.identity.started);
    return new Date(startedMs + timeS * MS_PER_S).toISOString();
  }

  private readAll(): Lanes {
    const tape = new Tape();
    const [workphases, signs, reasons] = [new Lane(), new Lane(), new Lane()];
    const lose = (cycle: number) =>
      [workphases, signs, reasons].forEach((lane) =>
        lane.take(cycle, UNKNOWN, "not known"),
      );
    let seen: Seen = {};
    let since: number | null = null;
    const takeWords = ({ state, time_s }: Reported) => {
      const { name } = state.status.workphase;
      const { kind, word, says } = signOf(viewOf(state));
      workphases.take(tape.cycle, name, words(name));
      signs.take(tape.cycle, kind, word);
      const reason = moves.includes(kind) ? "" : says;
      reasons.take(tape.cycle, reason, reason);
      seen = observe(seen, state, new Date(this.utcOf(time_s)));
    };
    this.rows.forEach((row, index) => {
      const hasWords = tape.take(row);
      const reported = tape.value as Reported | null;
      this.cycles.push(tape.cycle);
      if (index % KEPT_ROWS === 0) {
        this.kept.push(tape.copy());
      }
      if (reported === null) {
        lose(tape.cycle);
        this.trace.lose();
        [seen, since] = [{}, null];
      } else {
        since ??= tape.cycle;
        this.tracedFrom ??= tape.cycle;
        if (hasWords) {
          takeWords(reported);
        }
        if (row[0] >= 0) {
          this.trace.take(reported.state, 0);
        }
      }
      this.seen.push(seen);
      this.since.push(since ?? tape.cycle);
      this.traced.push(this.trace.length);
    });
    return {
      workphases: workphases.end(tape.cycle),
      signs: signs.end(tape.cycle),
      reasons: reasons.end(tape.cycle),
    };
  }
}

/** The recording in this page; null: it has none. */
export function recordingOf(page: Document): Recording | null {
  const text = page.getElementById("recording")?.textContent ?? "";
  return text === ""
    ? null
    : new Recording(JSON.parse(text) as RecordingDocument);
}
