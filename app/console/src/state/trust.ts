// SPDX-License-Identifier: Apache-2.0
// How far a position is to be believed.
import type { Axis, AxisReference } from "@interface";

export interface Trust {
  /** It has a place between its limits that may be shown. */
  isPlaced: boolean;
  /** In place of the number; null where the number is to be believed. */
  word: string | null;
  /** Kind of the number that is shown all the same. */
  mark: string;
}

const unknown: Trust = { isPlaced: false, word: "unknown", mark: "counted" };
/** Perhaps it was never known: homing that was left ends so too. */
const lost: Trust = { ...unknown, word: "lost" };
const believed: Trust = { isPlaced: true, word: null, mark: "" };

const trusts: Readonly<Record<AxisReference, Trust>> = {
  fresh: unknown,
  leave: unknown,
  approach: unknown,
  back_off: unknown,
  latch: unknown,
  lost,
  unverified: { isPlaced: true, word: "unverified", mark: "about" },
  taken: believed,
  verified: believed,
};

/** @satisfies SWR-CON-021 */
export function trustOf({ reference }: Axis): Trust {
  return trusts[reference] ?? unknown;
}

/** Its position is one of the robot, and not only counted from where it was switched on. */
export function isKnown(axis: Axis): boolean {
  return trustOf(axis).isPlaced;
}
