// SPDX-License-Identifier: Apache-2.0
// How many cycles of the robot are due by a clock of the world.

export const CYCLES_PER_MS = 1;
/** Time that the page was not run for, beyond this, has not passed for the robot. */
export const MOST_MS = 250;

/** @satisfies SWR-SITE-009 */
export class Pace {
  private share = 1;
  private owed = 0;
  private seenMs: number;

  constructor(nowMs: number) {
    this.seenMs = nowMs;
  }

  /** 1: as fast as the world; 0: it stands still. */
  set(share: number, nowMs: number): void {
    this.share = share;
    this.owed = 0;
    this.seenMs = nowMs;
  }

  get isPaused(): boolean {
    return this.share === 0;
  }

  /** Since the last time, whole cycles. */
  due(nowMs: number): number {
    const passedMs = Math.min(nowMs - this.seenMs, MOST_MS);
    this.seenMs = nowMs;
    this.owed += passedMs * this.share * CYCLES_PER_MS;
    const cycles = Math.max(0, Math.floor(this.owed));
    this.owed -= cycles;
    return cycles;
  }

  /** So many have passed beside these: who asks may wait for some. */
  spend(cycles: number): void {
    this.owed -= this.isPaused ? 0 : cycles;
  }
}
