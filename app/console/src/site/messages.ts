// SPDX-License-Identifier: Apache-2.0
// What the page and the worker of its robot say to each other.
import type { Question } from "./question";
import type { Asked, Answered, Told } from "./served_robot";

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
  /** Of the world's time; 0: none. */
  | { kind: "pace"; share: number }
  /** One cycle. */
  | { kind: "step" }
  /** To a cycle that has been; time stands still there. */
  | { kind: "go"; cycle: number }
  /** What was done until now, as a link to this robot. */
  | { kind: "share" }
  /** What would be if. */
  | { kind: "compare"; question: Question };

/** What somebody who sees the page can compare. */
export interface Identity {
  robot: string;
  checksum: string;
  build: string;
}

/** What would be if, from a cycle on. */
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
  | ({ kind: "told" } & Told)
  /** Cycles since the start, how far it has been, and how many inputs came after these cycles. */
  | { kind: "time"; cycles: number; end: number; later: number }
  /** It is at another cycle, and so is its server, which knows nothing of later. */
  | { kind: "restarted" }
  /** What was done until that cycle, as a link has it behind the #. */
  | { kind: "shared"; scene: string; inputs: number; cycle: number }
  | { kind: "unshared"; reason: string }
  | ({ kind: "compared" } & Comparison)
  /** What the link says cannot be done, and nothing else is shown. */
  | { kind: "refused"; reason: string }
  /** It does nothing more. */
  | { kind: "failed"; reason: string };
