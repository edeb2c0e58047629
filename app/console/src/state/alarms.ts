// SPDX-License-Identifier: Apache-2.0
// Alarms, their age, and the last known position of the needle, in words.
import type { Alarm, Status } from "@interface";
import { formatDuration, formatValue } from "../words/format";

/** The time of day. */
export function sinceText({ since }: Alarm): string {
  return since === null ? "" : `Since ${since.slice(11, 19)} UTC.`;
}

/**
 * Null while the needle is out, or nothing is wrong with it or against a motion.
 *
 * @satisfies SWR-CON-097
 */
export function needleText({ needle, alarms }: Status): string | null {
  const { axis, unit, position, age_s, is_known, may_be_in } = needle;
  const isWrong = alarms.some(({ reason }) => reason !== null);
  if (!may_be_in || !isWrong) {
    return null;
  }
  if (position === null) {
    return `The needle may be in the patient: where ${axis} stands has not been known since the server started.`;
  }
  const place = formatValue(position, unit);
  return is_known
    ? `The needle may be in the patient: ${axis} stands at ${place}.`
    : `The needle may be in the patient: ${axis} was last known at ${place}, ${formatDuration((age_s ?? 0) * 1000)} ago.`;
}
