// SPDX-License-Identifier: Apache-2.0
// Rule under test: no two sentences on one screen contradict each other, in any state of a long play by chance: banner, lamps,
// next step, workphase and buttons are looked at together after each act.
import { renderToStaticMarkup } from "react-dom/server";
import { expect, test } from "vitest";
import { lampsOf } from "../state/lamps";
import { Banner } from "../panels/shell/Banner";
import { signOf } from "../words/sign";
import type { ConsoleView } from "../state/store";
import { Chance } from "./chance";
import type { Play } from "./play";
import { readTable, Theatre } from "./table";

/** In each play. */
const ACTS = 100;
const TIMEOUT_MS = 120_000;
/** The scene of shown.yml with which a play begins, and the seed of the play. */
const BEGINNINGS = [
  ["idle", 1],
  ["homed", 2],
  ["aimed", 3],
  ["ready", 4],
  ["inserting", 5],
  ["reached", 6],
] as const;

/** The texts of a screen at one moment. */
interface Seen {
  /** The whole banner. */
  banner: string;
  /** The word of the sign. */
  sign: string;
  /** The name of the next step. */
  next: string;
  /** The words of the lamps, each behind its label. */
  lamps: readonly string[];
  /** Workphases whose buttons are refused. */
  refused: readonly string[];
}

type Says = (seen: Seen) => boolean;

const banner =
  (text: RegExp): Says =>
  (seen) =>
    text.test(seen.banner);
const sign =
  (...words: string[]): Says =>
  (seen) =>
    words.includes(seen.sign);
const lamp =
  (text: string): Says =>
  (seen) =>
    seen.lamps.includes(text);
const next =
  (...names: string[]): Says =>
  (seen) =>
    names.includes(seen.next);

const press = banner(/Press and hold the pedal|Keep the pedal pressed/);

/** Texts that may not stand together. */
const contradictions: Readonly<Record<string, readonly [Says, Says]>> = {
  "press and release the pedal": [press, banner(/[Rr]elease (the pedal|it)\b/)],
  "press the pedal, which is pressed": [
    next("PRESS_PEDAL"),
    lamp("Pedal PRESSED"),
  ],
  "keep the pedal pressed, which is not": [
    next("HOLD_PEDAL"),
    lamp("Pedal RELEASED"),
  ],
  "press it, and it is pressed": [
    banner(/The pedal is not pressed/),
    lamp("Pedal PRESSED"),
  ],
  "press the pedal under a standing fault": [
    press,
    sign("E-STOP", "CARD LOST", "FAULT"),
  ],
  "it moves, and something is to be done first": [
    sign("MOVING"),
    (seen) => !next("HOLD_PEDAL")(seen) && !/SCANNER|GRANT/.test(seen.next),
  ],
  "it may move, and waits for the pedal": [
    sign("MAY MOVE", "MOVING"),
    banner(/The pedal is not pressed/),
  ],
  "the e-stop is pulled, and not": [
    lamp("E-stop CLEAR"),
    banner(/e-stop is (pulled|latched)|Release the e-stop/),
  ],
  "the e-stop is to be released, and is": [
    next("RELEASE_ESTOP"),
    (seen) => !lamp("E-stop PULLED")(seen),
  ],
  "a motion goes on under a standing fault": [
    banner(/Moves /),
    sign("E-STOP", "CARD LOST", "FAULT"),
  ],
  "nothing is left to do under a standing fault": [
    next("NOTHING", "PROGRAM_DONE"),
    sign("E-STOP", "CARD LOST", "FAULT"),
  ],
  "the scanner is to be waited for, and is idle": [
    next("SCANNER"),
    lamp("Scanner IDLE"),
  ],
  "a command is asked for that is refused": [
    () => true,
    ({ next: name, refused }) =>
      refused.includes(name === "MOVE" ? "MOVE_TO_TARGET" : name),
  ],
};

function seenIn(play: Play): Seen {
  const robot = play.state();
  const { workphases } = play.outlook();
  const view: ConsoleView = {
    isConnected: true,
    refusal: null,
    freshness: "live",
    ageMs: 0,
    isOutdated: false,
    robot,
    log: [],
  };
  return {
    banner: renderToStaticMarkup(<Banner view={view} />).replace(
      /<[^>]*>/g,
      " ",
    ),
    sign: signOf(view).word,
    next: robot.status.next_step.name,
    lamps: lampsOf(robot.status, "live").map(
      ({ label, word }) => `${label} ${word}`,
    ),
    refused: workphases
      .filter(({ is_allowed }) => !is_allowed)
      .map(({ name }) => name),
  };
}

const theatre = new Theatre(readTable());

/** The names of the pairs that stand together, each with what was seen first. */
function judge(seen: Seen, done: string[], found: Map<string, string>): void {
  const { banner: reported, lamps, refused } = seen;
  for (const [name, [one, other]] of Object.entries(contradictions)) {
    if (!found.has(name) && one(seen) && other(seen)) {
      const after = done.slice(-4).join(" ");
      found.set(
        name,
        `${reported} ${[...lamps, "refused", ...refused].join(", ")}; after ${after}`,
      );
    }
  }
}

test.each(BEGINNINGS)(
  "SWR-CON-099 no two sentences contradict each other in a play from %s on",
  (stage, seed) => {
    const play = theatre.open(stage);
    const chance = new Chance(seed);
    const found = new Map<string, string>();
    const steps = new Set<string>();
    const done: string[] = [];
    for (let count = 0; count < ACTS; count += 1) {
      const one = chance.act(play.state().status.next_step.name);
      done.push(JSON.stringify(one));
      play.do(one);
      play.do(chance.wait());
      const seen = seenIn(play);
      steps.add(seen.next);
      judge(seen, done, found);
    }
    expect(Object.fromEntries(found)).toEqual({});
    // A play that stands still sees nothing.
    expect(steps.size).toBeGreaterThan(3);
  },
  TIMEOUT_MS,
);
