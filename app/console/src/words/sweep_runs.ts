// SPDX-License-Identifier: Apache-2.0
// A sweep while it runs, from what the log says of it.
import type { LogEntry } from "@interface";

/** Ways in ticks at a frequency; null before that run. */
export interface SweepRun {
  hertz: number;
  upwards: number | null;
  downwards: number | null;
}

/** Those of the last sweep that was begun, in their order; the oldest entry comes first. */
export function readRuns(entries: readonly LogEntry[]): SweepRun[] {
  const begun = entries.findLastIndex(({ name }) => name === "SWEEP_BEGUN");
  const runs = new Map<number, SweepRun>();
  let hertz = Number.NaN;
  for (const { name, value } of entries.slice(begun + 1)) {
    const run = runs.get(hertz) ?? { hertz, upwards: null, downwards: null };
    if (name === "SWEEP_WORD") {
      hertz = value;
    } else if (name === "SWEEP_UPWARDS") {
      runs.set(hertz, { ...run, upwards: value });
    } else if (name === "SWEEP_DOWNWARDS") {
      runs.set(hertz, { ...run, downwards: value });
    }
  }
  return [...runs.values()];
}
