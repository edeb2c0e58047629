// SPDX-License-Identifier: Apache-2.0
// Acts by chance, the same for the same seed.
import type { Act } from "./play";

const REGISTRATION = [
  0.999550034, 0.0299955, 0, -4, -0.029989501, 0.99935013, -0.019998667, -128,
  -0.00059987, 0.019989668, 0.999800007, -33, 0, 0, 0, 1,
];
const TARGET = [
  -0.996809196, 0.002994553, -0.079765029, -3.523, 0.079549401, 0.119667295,
  -0.989621964, 61.989, 0.006581789, -0.992809534, -0.119523675, 11.74, 0, 0, 0,
  1,
];
const WORKPHASES = [
  "START_UP",
  "PLANNING",
  "CALIBRATION",
  "TARGETING",
  "MOVE_TO_TARGET",
  "MANUAL",
];
/** A fault, and what mends it. */
const FAULTS: readonly (readonly [string, string])[] = [
  ["estop pull", "estop reset"],
  ["card 3 silent", "card 3 normal"],
  ["card 1 silent", "card 1 normal"],
  ["card 3 corrupt", "card 3 normal"],
  ["encoder 3 stuck", "encoder 3 normal"],
  ["motor 1 stuck", "motor 1 normal"],
  ["scanner on", "scanner off"],
  ["pedal a open", "pedal a close"],
];
const MOST_WAITED = 2500;

export class Chance {
  private seed: number;

  constructor(seed: number) {
    this.seed = seed;
  }

  /** From 0 to below `count`. */
  below(count: number): number {
    this.seed = (Math.imul(this.seed, 1664525) + 1013904223) >>> 0;
    return Math.floor((this.seed / 2 ** 32) * count);
  }

  of<One>(ones: readonly One[]): One {
    return ones[this.below(ones.length)]!;
  }

  wait(): Act {
    return { wait: 1 + this.below(MOST_WAITED) };
  }

  /** The next act: in two of three cases it follows `asked`, the name of the next step. */
  act(asked: string): Act {
    switch (this.below(9)) {
      case 0:
        return { order: this.of(this.of(FAULTS)) };
      case 1:
        return { order: this.of(FAULTS)[1] };
      case 2:
        return this.anything();
      default:
        return this.followed(asked);
    }
  }

  private anything(): Act {
    return this.of<Act>([
      { post: "workphase", body: { workphase: this.of(WORKPHASES) } },
      { post: "box", body: { pedal: this.of(["hold", "drop"]) } },
      { post: "stop" },
      { delete: "authority" },
    ]);
  }

  private followed(asked: string): Act {
    const workphase = asked === "MOVE" ? "MOVE_TO_TARGET" : asked;
    if (WORKPHASES.includes(workphase)) {
      return { post: "workphase", body: { workphase } };
    }
    switch (asked) {
      case "AUTHORITY":
        return { post: "authority" };
      case "PRESS_PEDAL":
      case "HOLD_PEDAL":
        return { post: "box", body: { pedal: "hold" } };
      case "REGISTER":
        return {
          post: "targeting/registration",
          body: { matrix: REGISTRATION },
        };
      case "TARGET":
        return { post: "targeting/target", body: { matrix: TARGET } };
      case "RELEASE_PEDAL":
      case "PEDAL_FAULT":
        return { post: "box", body: { pedal: "drop" } };
      default:
        return { order: this.of(FAULTS)[1] };
    }
  }
}
