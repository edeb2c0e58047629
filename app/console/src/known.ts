// SPDX-License-Identifier: Apache-2.0
import type { Axis, AxisReference } from "@interface";

const known: readonly AxisReference[] = ["verified", "taken", "unverified"];

/** Its position is one of the robot, and not only counted from where it was switched on. */
export function isKnown(axis: Axis): boolean {
  return known.includes(axis.reference);
}
