// SPDX-License-Identifier: Apache-2.0

export type Freshness = "live" | "late" | "stale";

export const LATE_MS = 300;
/** With the checks 100 ms apart, stale data is marked within a second. */
export const STALE_MS = 700;

/** @satisfies SWR-CON-004 */
export function freshnessOf(ageMs: number): Freshness {
  if (ageMs > STALE_MS) {
    return "stale";
  }
  return ageMs > LATE_MS ? "late" : "live";
}
