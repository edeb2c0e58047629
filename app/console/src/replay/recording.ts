// SPDX-License-Identifier: Apache-2.0
// A recording as boresight-replay --html has written it, for looking at any of its cycles.
import type { LogEntry, Robot, RobotState } from "@interface";
import { observe, type Seen } from "../chart_states";
import { words } from "../format";
import { signOf, type SignKind } from "../sign";
import type { ConsoleView } from "../store";
import { Trace } from "../trace";
import { Tape, type Row } from "./tape";

const FORMAT = 1;
/** After so many rows the whole is kept, so that no cycle is far from one that is known. */
const KEPT_ROWS = 500;
const MS_PER_S = 1000;
const CYCLES_PER_S = 1000;

/** What left to a card, by the names of core/card. */
export type Frame = Readonly<Record<string, string | number>>;

/** What is told of a cycle. */
interface Told {
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

export interface Lanes {
  workphases: readonly Span[];
  signs: readonly Span[];
  reasons: readonly Span[];
}

/** What the console would have shown. */
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

/** @satisfies SWR-REPLAY-018 */
export class Recording {
  readonly robot: Robot;
  readonly identity: Identity;
  readonly events: readonly LogEntry[];
  readonly first: number;
  readonly last: number;
  readonly lanes: Lanes;
  /** All of it. */
  readonly trace = new Trace(Infinity);
  private readonly rows: readonly Row[];
  private readonly cycles: number[] = [];
  private readonly kept: Tape[] = [];
  /** Of each row: what was seen of the charts, and how long the trace was. */
  private readonly seen: Seen[] = [];
  private readonly traced: number[] = [];

  constructor(written: RecordingDocument) {
    if (written.format !== FORMAT) {
      throw new Error(`The recording is of format ${written.format}.`);
    }
    this.robot = written.robot;
    this.identity = written.recording;
    this.events = written.events;
    this.rows = written.rows;
    this.lanes = this.readAll();
    this.first = this.cycles[0] ?? 0;
    this.last = this.cycles.at(-1) ?? 0;
  }

  get isEmpty(): boolean {
    return this.rows.length === 0;
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

  at(cycle: number): Moment {
    const row = this.rowOf(cycle);
    const begin = Math.floor(row / KEPT_ROWS);
    const tape = this.kept[begin]!.copy();
    this.rows
      .slice(begin * KEPT_ROWS + 1, row + 1)
      .forEach((one) => tape.take(one));
    const { state, frames, time_s } = tape.value as Told;
    const timeS = time_s + (cycle - tape.counted) / CYCLES_PER_S;
    return {
      cycle,
      timeS,
      robot: { ...state, status: { ...state.status, utc: this.utcOf(timeS) } },
      frames,
      seen: this.seen[row]!,
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
    let seen: Seen = {};
    this.rows.forEach((row, index) => {
      const hasWords = tape.take(row);
      const { state, time_s } = tape.value as Told;
      this.cycles.push(tape.cycle);
      if (index % KEPT_ROWS === 0) {
        this.kept.push(tape.copy());
      }
      if (hasWords) {
        const { name } = state.status.workphase;
        const { kind, word, says } = signOf(viewOf(state));
        workphases.take(tape.cycle, name, words(name));
        signs.take(tape.cycle, kind, word);
        const reason = moves.includes(kind) ? "" : says;
        reasons.take(tape.cycle, reason, reason);
        seen = observe(seen, state, new Date(this.utcOf(time_s)));
      }
      if (row[0] >= 0) {
        this.trace.take(state, 0);
      }
      this.seen.push(seen);
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
