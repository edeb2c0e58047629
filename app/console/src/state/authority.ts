// SPDX-License-Identifier: Apache-2.0
// Authority of this page: it takes it, renews it by itself, and gives it up when no user sees it any more. Which page it is
// stands in its memory alone, so a reload or another tab is another page.
import { commands, type Authority, type Path } from "@interface";
import type { Page } from "./page";

/** The server takes it away after 5 s of the robot's time without. */
export const RENEW_MS = 2000;
/** One refusal may have been judged by what was so before this page took command. */
const REFUSALS = 2;
/** From this status on the server has failed or is busy, and has judged nothing. */
const FAILED = 500;

export class PageAuthority {
  private readonly page: Page;
  private readonly listeners = new Set<() => void>();
  private hasAsked = false;
  private timer: ReturnType<typeof setInterval> | null = null;
  private problem: string | null = null;
  private speedup = 1;
  /** Renewals in a row that were refused. */
  private refusals = 0;
  /** By the stream, this page has authority or asks for it. */
  private isNamed = false;
  /** How this page has given it up itself. */
  left: "by hand" | "hidden" | null = null;

  constructor(page: Page) {
    this.page = page;
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  /** Why the last thing that was asked for was not done. */
  readonly getProblem = (): string | null => this.problem;

  /**
   * Gives up when the page is hidden or closed, until `stop()`.
   *
   * @satisfies SWR-CON-015
   */
  start(): void {
    document.addEventListener("visibilitychange", this.leave);
    window.addEventListener("pagehide", this.giveUp);
  }

  stop(): void {
    document.removeEventListener("visibilitychange", this.leave);
    window.removeEventListener("pagehide", this.giveUp);
    this.giveUp();
  }

  isMine(authority: Authority): boolean {
    return authority.source === "HTTP" && authority.peer === this.page.number;
  }

  /** It is this page that waits for the button. */
  isAsking(authority: Authority): boolean {
    return (
      authority.requester === "HTTP" &&
      authority.requester_peer === this.page.number
    );
  }

  /** Takes authority that no client has. */
  async take(): Promise<void> {
    if (await this.act(commands.TAKE.path, {})) {
      this.keep();
      this.leave();
    }
  }

  /** Asks for the button at the box. The stream shows which client has authority then. */
  async ask(): Promise<void> {
    this.hasAsked = await this.act(commands.REQUEST.path, { what: "TAKE" });
    this.leave();
  }

  /** The button was pressed for this page; the robot's time passes up to `speedup` times faster than the world's. */
  notice(authority: Authority, speedup = 1): void {
    this.speedup = speedup;
    this.isNamed = this.isMine(authority) || this.isAsking(authority);
    if (this.hasAsked && this.isMine(authority)) {
      this.hasAsked = false;
      this.keep();
    }
  }

  /** Gives it up, or withdraws what was asked for. It leaves even when the page does. */
  readonly giveUp = (): void => this.end("by hand");

  /** @satisfies SWR-CON-320 */
  private end(left: "by hand" | "hidden"): void {
    if (this.timer !== null || this.hasAsked || this.isNamed) {
      this.left = left;
      this.letGo();
      this.hasAsked = false;
      this.isNamed = false;
      void this.page.request("DELETE", commands.RELEASE.path).catch(
        () => undefined, // Without renewal it ends all the same.
      );
    }
  }

  /** Also looked at when an answer comes: a page that has been left meanwhile must not keep authority. */
  private readonly leave = (): void => {
    if (document.visibilityState === "hidden") {
      this.end("hidden");
    }
  };

  /** @satisfies SWR-BOX-045 */
  private keep(): void {
    this.left = null;
    this.refusals = 0;
    this.timer ??= setInterval(
      () => void this.renew(),
      RENEW_MS / this.speedup,
    );
  }

  private letGo(): void {
    if (this.timer !== null) {
      clearInterval(this.timer);
      this.timer = null;
    }
  }

  /** A server that fails or does not answer may do better the next time; one that refuses twice has given it to no client or another. */
  private async renew(): Promise<void> {
    try {
      const response = await this.page.request("PUT", commands.RENEW.path);
      if (response.ok) {
        this.refusals = 0;
      } else if (response.status < FAILED) {
        this.refusals += 1;
      }
      if (this.refusals >= REFUSALS) {
        this.letGo();
      }
    } catch {
      // The rest of the page says that the server does not answer.
    }
  }

  /** True when it was done. */
  private async act(path: Path, fields: object): Promise<boolean> {
    const problem = await this.page.act(path, fields);
    this.notify(problem);
    return problem === null;
  }

  private notify(problem: string | null): void {
    this.problem = problem;
    this.listeners.forEach((listener) => listener());
  }
}
