// SPDX-License-Identifier: Apache-2.0
import type {
  BoxInput,
  Card,
  CardLinkState,
  EstopLatchState,
  LoopGuardState,
  PedalGateState,
  Status,
} from "@interface";
import { formatCycles, formatMinutes } from "../words/format";
import type { Freshness } from "./freshness";

/**
 * How much a lamp wants to be looked at. Each level has a shape and a colour of its own; the base is grey, and
 * colour means that something is not as usual.
 */
export type Level = "normal" | "active" | "attention" | "fault" | "unknown";

/** @satisfies SWR-CON-002 */
export interface LampState {
  level: Level;
  word: string;
}

/** A state without its lamp does not compile. */
type Table<State extends string = string> = Readonly<Record<State, LampState>>;

const pedal: Table<PedalGateState> = {
  unproven: { level: "attention", word: "RELEASE ONCE" },
  released: { level: "normal", word: "RELEASED" },
  closing: { level: "attention", word: "ONE CHANNEL" },
  pressed: { level: "active", word: "PRESSED" },
  opening: { level: "attention", word: "LETTING GO" },
  fault: { level: "fault", word: "FAULT" },
};

const estop: Table<EstopLatchState> = {
  clear: { level: "normal", word: "CLEAR" },
  pulled: { level: "fault", word: "PULLED" },
  latched: { level: "attention", word: "LATCHED" },
};

const loop: Table<LoopGuardState> = {
  on_time: { level: "normal", word: "ON TIME" },
  late_once: { level: "attention", word: "LATE" },
  late_twice: { level: "attention", word: "LATE TWICE" },
  stopped: { level: "fault", word: "STOPPED" },
};

const link: Table<CardLinkState> = {
  absent: { level: "unknown", word: "ABSENT" },
  live: { level: "normal", word: "LIVE" },
  late: { level: "attention", word: "LATE" },
  lost: { level: "fault", word: "LOST" },
};

/** The tables by lamp, for those who check them. */
export const lampTables: Readonly<Record<string, Table>> = {
  pedal,
  estop,
  loop,
  link,
};

function find(table: Table, state: string): LampState {
  return table[state] ?? { level: "unknown", word: state.toUpperCase() };
}

export interface LampProperties extends LampState {
  label: string;
  detail?: string;
}

const dataLevels: Readonly<Record<Freshness, LampState>> = {
  live: { level: "normal", word: "LIVE" },
  late: { level: "attention", word: "LATE" },
  stale: { level: "fault", word: "STALE" },
};

/** An age in words: below a tenth of a second it is not worth a number. */
export function ageText(ageMs: number): string {
  if (ageMs < 100) {
    return "under 0.1 s";
  }
  return ageMs < 10_000
    ? `${(ageMs / 1000).toFixed(1)} s`
    : `${Math.round(ageMs / 1000)} s`;
}

export function dataLamp(freshness: Freshness, ageMs: number): LampProperties {
  const lamp = { label: "Data", ...dataLevels[freshness] };
  return freshness === "live" ? lamp : { ...lamp, detail: ageText(ageMs) };
}

function processLamp(label: string, isRunning: boolean): LampProperties {
  return isRunning
    ? { label, level: "normal", word: "RUNNING" }
    : { label, level: "unknown", word: "NOT RUNNING" };
}

/** Minutes below which it is time to free some space. */
const FEW_MIN = 30;

/** @satisfies SWR-CON-092 */
function roomLamp(lamp: LampProperties, left: number): LampProperties {
  const detail = `disk full in ${formatMinutes(left)} at this rate`;
  return left < FEW_MIN
    ? { ...lamp, level: "attention", word: "FULL SOON", detail }
    : { ...lamp, detail };
}

/** A recorder that runs and records nothing is none. */
function recorderLamp(status: Status): LampProperties {
  const lamp = processLamp("Recorder", status.processes.recorder);
  if (status.is_recorder_failing) {
    return { ...lamp, level: "fault", word: "CANNOT WRITE" };
  }
  if (!status.processes.recorder) {
    return lamp;
  }
  if (status.counts.unrecorded > 0) {
    return { ...lamp, level: "fault", word: "BEHIND" };
  }
  const left = status.recording_left_min;
  return left === 0 ? lamp : roomLamp(lamp, left);
}

/** Those of the robot; any other card has its lamp beside theirs. */
function cardsLamp(cards: readonly Card[]): LampProperties {
  const own = cards.filter(({ axis }) => axis !== null);
  const live = own.filter(({ link }) => link === "live").length;
  const isAnyLost = own.some(({ link }) => link === "lost");
  return {
    label: "Cards",
    level: live === own.length ? "normal" : isAnyLost ? "fault" : "attention",
    word: `${live} OF ${own.length}`,
  };
}

/** A slow simulation must not be taken for a slow robot, nor a fast one for a fast robot. */
const SLOW_PERCENT = 95;

function timeLamp({ cycle, time }: Status): LampProperties {
  const percent = Math.round(time.speed_percent);
  const lamp = {
    label: "Since start",
    word: formatCycles(cycle),
  };
  return percent < SLOW_PERCENT || time.speedup > 1
    ? { ...lamp, level: "attention", detail: `${percent}\u00a0%` }
    : { ...lamp, level: "normal" };
}

/** None is believed that is of stale data. */
export function lampsOf(
  status: Status,
  freshness: Freshness,
): LampProperties[] {
  const lamps = systemLamps(status);
  return freshness === "stale"
    ? lamps.map(({ label }) => ({ label, level: "unknown", word: "UNKNOWN" }))
    : lamps;
}

/** The level of an input is not known while it is not read. */
const notRead: LampState = { level: "fault", word: "NOT READ" };

/** @satisfies SWR-CON-130 */
export function systemLamps(status: Status): LampProperties[] {
  const scanner: LampState = status.is_scanner_active
    ? { level: "active", word: "ACQUIRING" }
    : { level: "normal", word: "IDLE" };
  const read = (input: BoxInput, lamp: LampState): LampState =>
    status.unread_inputs.some(({ name }) => name === input) ? notRead : lamp;
  return [
    { label: "Pedal", ...read("PEDAL", find(pedal, status.pedal)) },
    { label: "E-stop", ...read("ESTOP", find(estop, status.estop)) },
    { label: "Scanner", ...read("SCANNER", scanner) },
    cardsLamp(status.cards),
    { label: "Control loop", ...find(loop, status.loop.state) },
    processLamp("OpenIGTLink", status.processes.igtl),
    recorderLamp(status),
    timeLamp(status),
  ];
}

export function cardLamp(card: Card): LampProperties {
  const faults = card.faults.join(", ");
  return {
    label: `Card ${card.slot}, ${card.axis ?? "no axis"}`,
    ...find(link, card.link),
    ...(faults === "" ? {} : { detail: faults }),
  };
}
