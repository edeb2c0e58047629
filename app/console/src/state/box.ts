// SPDX-License-Identifier: Apache-2.0
// This page at the simulated box: its orders there, and the handles that it holds. A page that holds one repeats it; the
// server forgets a page that does not, and the box itself lets go then.
import { Box, type BoxOrderRequest, type Path, type Problem } from "@interface";
import { refusalOf, type Method, type Page } from "./page";
import { fitted } from "../words/shape";

const BOX_PATH: Path = "/api/v1/box";
/** The box lets go after 1.5 s without. */
export const KEEP_MS = 500;
export const LOOK_MS = 1000;

export type Handle = "pedal" | "button" | "hand";

/** Latched: it stays until it is let go by another act, or by what ends a hold of any kind. */
export type Hold = "none" | "held" | "latched";

export interface BoxView {
  /** Null before the first answer, and after one that failed. */
  box: Box | null;
  pedal: Hold;
  button: Hold;
  hand: Hold;
  /** Why the last thing was not done, or a hold has ended. */
  problem: string | null;
}

const handles: readonly Handle[] = ["pedal", "button", "hand"];
const NO_ANSWER = "The server does not answer.";
const LET_GO = "It was let go at the box.";

export class BoxHands {
  private readonly page: Page;
  private readonly listeners = new Set<() => void>();
  private readonly confirmed = new Set<Handle>();
  private view: BoxView = {
    box: null,
    pedal: "none",
    button: "none",
    hand: "none",
    problem: null,
  };
  private looks: ReturnType<typeof setInterval> | null = null;
  private timer: ReturnType<typeof setInterval> | null = null;
  private isKeeping = false;

  constructor(page: Page) {
    this.page = page;
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  readonly getView = (): BoxView => this.view;

  /**
   * Looks, and lets go when the page is not seen or not the one that is typed into, until `stop()`.
   *
   * @satisfies SWR-CON-041
   */
  start(): void {
    document.addEventListener("visibilitychange", this.leave);
    window.addEventListener("pagehide", this.letGo);
    window.addEventListener("blur", this.letGo);
    void this.look();
    this.looks = setInterval(() => void this.look(), LOOK_MS);
  }

  stop(): void {
    document.removeEventListener("visibilitychange", this.leave);
    window.removeEventListener("pagehide", this.letGo);
    window.removeEventListener("blur", this.letGo);
    if (this.looks !== null) {
      clearInterval(this.looks);
    }
    this.letGo();
  }

  async order(order: BoxOrderRequest): Promise<boolean> {
    return this.notify(await this.ask("POST", order));
  }

  /** Holds it until `drop()`. A page that has let go before the answer came does not hold the handle. */
  async hold(handle: Handle, hold: "held" | "latched"): Promise<void> {
    if (this.view[handle] !== "none" || document.visibilityState === "hidden") {
      return;
    }
    this.replace({ [handle]: hold });
    const problem = await this.ask("POST", { [handle]: "hold" });
    this.notify(problem);
    if (problem !== null) {
      this.forget(handle);
      await this.dropStray();
    } else if (this.view[handle] === "none") {
      await this.ask("POST", { [handle]: "drop" });
    } else {
      this.confirmed.add(handle);
      this.timer ??= setInterval(() => void this.keep(), KEEP_MS);
    }
  }

  async drop(handle: Handle): Promise<void> {
    if (this.view[handle] !== "none") {
      this.forget(handle);
      await this.order({ [handle]: "drop" });
    }
  }

  /** All that it holds. It leaves even when the page does. */
  readonly letGo = (): void => {
    if (handles.some((handle) => this.view[handle] !== "none")) {
      handles.forEach((handle) => this.forget(handle));
      void this.ask("DELETE");
    }
  };

  private readonly leave = (): void => {
    if (document.visibilityState === "hidden") {
      this.letGo();
    }
  };

  private forget(handle: Handle): void {
    this.confirmed.delete(handle);
    this.replace({ [handle]: "none" });
    if (this.confirmed.size === 0 && this.timer !== null) {
      clearInterval(this.timer);
      this.timer = null;
    }
  }

  private async look(): Promise<void> {
    const before = this.view.problem;
    if ((await this.ask("GET")) !== null) {
      this.replace({ box: null, problem: before });
    }
  }

  /** A renewal is of all that the page holds at the box, so what it has let go must not be among that. */
  private async dropStray(): Promise<void> {
    for (const handle of handles) {
      if (this.view[handle] === "none" && this.isMine(handle)) {
        await this.ask("POST", { [handle]: "drop" });
      }
    }
  }

  /** A handle that was let go meanwhile stays so: nothing closes again by itself. */
  private async keep(): Promise<void> {
    if (this.isKeeping) {
      return;
    }
    this.isKeeping = true;
    const kept = [...this.confirmed];
    const problem = await this.ask("PUT");
    this.isKeeping = false;
    if (problem !== null) {
      this.notify(problem);
      this.letGo();
      return;
    }
    for (const handle of kept) {
      if (this.confirmed.has(handle) && !this.isMine(handle)) {
        this.forget(handle);
        this.notify(LET_GO);
      }
    }
    await this.dropStray();
  }

  private isMine(handle: Handle): boolean {
    return this.view.box?.[`${handle}_holder`] === this.page.number;
  }

  /** Null when it was done; then what is seen at the box is known. */
  private async ask(
    method: Method,
    order?: BoxOrderRequest,
  ): Promise<string | null> {
    try {
      const body = order && JSON.stringify(order);
      const response = await this.page.request(method, BOX_PATH, body);
      const answer: unknown = await response.json();
      if (!response.ok) {
        return refusalOf(answer as Partial<Problem>);
      }
      this.replace({ box: fitted(answer, Box, BOX_PATH) });
      return null;
    } catch {
      return NO_ANSWER;
    }
  }

  private notify(problem: string | null): boolean {
    this.replace({ problem });
    return problem === null;
  }

  private replace(change: Partial<BoxView>): void {
    this.view = { ...this.view, ...change };
    this.listeners.forEach((listener) => listener());
  }
}
