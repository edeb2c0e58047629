// SPDX-License-Identifier: Apache-2.0
// What the page and the worker of its robot say to each other.
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
  | { kind: "step" };

/** What somebody who sees the page can compare. */
export interface Identity {
  robot: string;
  checksum: string;
  build: string;
}

/** To the page. */
export type Report =
  | ({ kind: "started" } & Identity)
  | { kind: "answer"; id: number; answered: Answered }
  | ({ kind: "told" } & Told)
  /** Cycles since the start. */
  | { kind: "time"; cycles: number }
  /** What the link says cannot be done, and nothing else is shown. */
  | { kind: "refused"; reason: string }
  /** It does nothing more. */
  | { kind: "failed"; reason: string };
