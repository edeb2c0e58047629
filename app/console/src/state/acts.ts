// SPDX-License-Identifier: Apache-2.0
// Results of the last acts of this page: from the answer to each, or later from the stream, in any order.
import type { Act, Path } from "@interface";
import { refusalOf } from "./refusal";

export interface Outcome {
  id: number;
  path: Path;
  fields: object;
  /** Sent: there is no answer yet. Accepted: it was begun. Lost: its end could not be heard. */
  state: "sent" | "accepted" | "done" | "failed" | "lost";
  /** Why it failed, or null. */
  reason: string | null;
}

/** A listener that is informed how acts ended that had been begun. */
export interface ActListener {
  hearAct(act: Act): void;
  /** The stream was interrupted: the ends of acts meanwhile are not reported again. */
  loseActs(): void;
}

const KEPT = 8;

/**
 * The last acts, whichever panel they came from, and whether that is still shown.
 *
 * @satisfies SWR-CON-033
 * @satisfies SWR-CON-046
 */
export class RecentActs implements ActListener {
  private readonly page: number;
  private readonly listeners = new Set<() => void>();
  private outcomes: readonly Outcome[] = [];

  constructor(page: number) {
    this.page = page;
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  /** Outcome of the last one. */
  readonly getOutcome = (): Outcome | null => this.outcomes[0] ?? null;

  /** Outcomes of all that are kept, the newest first. */
  readonly getOutcomes = (): readonly Outcome[] => this.outcomes;

  begin(id: number, path: Path, fields: object): void {
    const begun = { id, path, fields, state: "sent", reason: null } as const;
    this.replace([begun, ...this.outcomes].slice(0, KEPT));
  }

  /** The stream may have reported its end before the answer states that it was begun. */
  answer(id: number, state: "accepted" | "done"): void {
    this.change((one) => one.id === id && one.state === "sent", { state });
  }

  fail(id: number, reason: string): void {
    this.change((one) => one.id === id, { state: "failed", reason });
  }

  hearAct(act: Act): void {
    const { id, page, state, message: detail } = act;
    if (page !== this.page) {
      return;
    }
    if (state === "failed") {
      this.fail(id, refusalOf({ ...act, detail }));
    } else {
      this.change((one) => one.id === id, { state });
    }
  }

  loseActs(): void {
    this.change((one) => one.state === "accepted", { state: "lost" });
  }

  private change(
    isMeant: (outcome: Outcome) => boolean,
    change: Partial<Outcome>,
  ): void {
    if (this.outcomes.some(isMeant)) {
      this.replace(
        this.outcomes.map((one) =>
          isMeant(one) ? { ...one, ...change } : one,
        ),
      );
    }
  }

  private replace(outcomes: readonly Outcome[]): void {
    this.outcomes = outcomes;
    this.listeners.forEach((listener) => listener());
  }
}
