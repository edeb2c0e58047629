// SPDX-License-Identifier: Apache-2.0
// Why something was not done, for people.
import type { Problem } from "@interface";

export const NO_ANSWER = "The server does not answer.";

export interface Refusal {
  detail?: string | undefined;
  axis?: string | null | undefined;
  limit?: Problem["limit"] | null;
}

/** In words, with the axis and the limit that are why. */
export function refusalOf({ detail, axis, limit }: Refusal): string {
  const sentence = detail ?? "It was refused.";
  if (axis === undefined || axis === null) {
    return sentence;
  }
  const end = limit === undefined || limit === null ? "" : `, ${limit} limit`;
  return `${sentence} (${axis}${end})`;
}
