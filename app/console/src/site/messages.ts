// SPDX-License-Identifier: Apache-2.0
// Messages between the page and the worker of its robot.
import type { Question } from "./question";
import type { Asked, Answered, Reported } from "./served_robot";

/** From the page. The first is `start`. */
export type Order =
  | {
      kind: "start";
      /** The module: gzip, as base64. */
      packed: string;
      robot: string;
      seed: number;
      /** Text of a scene that is played instead; null: none. */
      scene: string | null;
      utcS: number;
    }
  | { kind: "ask"; id: number; asked: Asked }
  /** Share of the world's time; 0: none. */
  | { kind: "pace"; share: number }
  /** One cycle. */
  | { kind: "step" }
  /** To a cycle that has been; time stands still there. */
  | { kind: "go"; cycle: number }
  /** Asks for the inputs until now, as a link to this robot. */
  | { kind: "share" }
  /** Asks "what if". */
  | { kind: "compare"; question: Question };

/** Values that a user of the page can compare. */
export interface Identity {
  robot: string;
  checksum: string;
  build: string;
}

/** The answer to "what if", from a cycle on. */
export interface Comparison {
  question: Question;
  cycle: number;
  /** The first difference in words; none: there is none. */
  lines: string[];
  /** Why it was not compared. */
  problem: string | null;
  /** All that is done to the robot, as a link has it; null: it is no link. */
  scene: string | null;
}

/** To the page. */
export type Report =
  | ({ kind: "started"; inputs: string[] } & Identity)
  | { kind: "answer"; id: number; answered: Answered }
  | ({ kind: "reported" } & Reported)
  /** Cycles since the start, how far it has been, and how many inputs came after these cycles. */
  | { kind: "time"; cycles: number; end: number; later: number }
  /** It is at another cycle, and so is its server, which knows nothing of later. */
  | { kind: "restarted" }
  /** The inputs until that cycle, as a link has them behind the #. */
  | { kind: "shared"; scene: string; inputs: number; cycle: number }
  | { kind: "unshared"; reason: string }
  | ({ kind: "compared" } & Comparison)
  /** The scene of the link cannot be played, and nothing else is shown. */
  | { kind: "refused"; reason: string }
  /** It does nothing more. */
  | { kind: "failed"; reason: string };
