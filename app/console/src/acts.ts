// SPDX-License-Identifier: Apache-2.0
// What became of the last act of this page: told by the answer to it, or later by the stream, in whatever order they come.
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

/** Who is told how acts ended that had been begun. */
export interface ActListener {
  hearAct(act: Act): void;
  /** The stream was interrupted: what ended meanwhile is not told again. */
  loseActs(): void;
}

/**
 * The last act alone: what comes after it discards what it had armed.
 *
 * @satisfies SWR-CON-033
 */
export class LastAct implements ActListener {
  private readonly page: number;
  private readonly listeners = new Set<() => void>();
  private outcome: Outcome | null = null;

  constructor(page: number) {
    this.page = page;
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  readonly getOutcome = (): Outcome | null => this.outcome;

  begin(id: number, path: Path, fields: object): void {
    this.replace({ id, path, fields, state: "sent", reason: null });
  }

  /** The stream may have told its end before the answer says that it was begun. */
  answer(id: number, state: "accepted" | "done"): void {
    if (this.outcome?.id === id && this.outcome.state === "sent") {
      this.replace({ ...this.outcome, state });
    }
  }

  fail(id: number, reason: string): void {
    if (this.outcome?.id === id) {
      this.replace({ ...this.outcome, state: "failed", reason });
    }
  }

  hearAct(act: Act): void {
    if (act.page !== this.page || act.id !== this.outcome?.id) {
      return;
    }
    if (act.state === "failed") {
      this.fail(act.id, refusalOf({ ...act, detail: act.message }));
    } else {
      this.replace({ ...this.outcome, state: act.state });
    }
  }

  loseActs(): void {
    if (this.outcome?.state === "accepted") {
      this.replace({ ...this.outcome, state: "lost" });
    }
  }

  private replace(outcome: Outcome): void {
    this.outcome = outcome;
    this.listeners.forEach((listener) => listener());
  }
}
