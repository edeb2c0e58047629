// SPDX-License-Identifier: Apache-2.0
// The command and the session that this page had and has lost, and why, until the user has read it.
import type { LogEntry, Session, Status } from "@interface";
import type { Operation } from "./operation";
import { secondsLeft } from "./session";

/** The server counts whole seconds. */
const COUNTED_MS = 1000;

/** By the value of the event AUTHORITY_LOST. */
const causes = [
  "the server gave it up",
  "the server did not hear this page in time",
  "the server gave no sign of life",
  "another took it by the button at the box",
] as const;
/** Until the event has come. */
const UNKNOWN = "the log has the reason";

export interface Sight {
  status: Status;
  session: Session | null;
  log: readonly LogEntry[];
}

/** A session, and when it ends without a command. */
interface Login {
  session: Session;
  endsAt: number;
  /** When its server was seen last. */
  servedAt: number;
  /** When another start of the server was seen first, or null. */
  anewAt: number | null;
}

/** The cause when the server that knew the session runs no more. */
function endAnew({ endsAt, servedAt, anewAt }: Login): string | null {
  if (servedAt >= endsAt) {
    return null; // The session ended under the server that knew it.
  }
  return (anewAt ?? performance.now()) < endsAt - COUNTED_MS
    ? "the server was started anew, and no session outlives that"
    : "the server was started anew, or its time was over before";
}

/** Why it ended; `bootId` is the start of the server that says so, which the stream may not have shown yet. */
function endOf(login: Login, bootId: string): string {
  const { session, endsAt } = login;
  const anew = session.boot_id === bootId ? null : endAnew(login);
  if (anew !== null) {
    return anew;
  }
  if (performance.now() < endsAt - COUNTED_MS) {
    return "by a logout in another tab, another login or a change of the account; the log says which";
  }
  return session.most_s <= session.idle_s
    ? "the session has lasted as long as one may"
    : "nothing was commanded or renewed for too long";
}

export class Losses {
  private readonly operation: Operation;
  private readonly listeners = new Set<() => void>();
  private login: Login | null = null;
  private status: Status | null = null;
  private boot = "";
  /** The start of the server at which this page took command; null: it has none. */
  private taken: string | null = null;
  private command: string | null = null;
  private logout: string | null = null;
  private sentences: readonly string[] = [];

  constructor(operation: Operation) {
    this.operation = operation;
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  readonly getSentences = (): readonly string[] => this.sentences;

  /** They were read. */
  readonly dismiss = (): void => {
    this.command = null;
    this.logout = null;
    this.notify();
  };

  /** Takes the present view of the page. */
  observe({ status, session, log }: Sight): void {
    const isAnew = this.boot !== "" && this.boot !== status.boot_id;
    this.boot = status.boot_id;
    this.observeServer(status);
    this.observeSession(session);
    const isLost = this.observeCommand(status);
    if (isLost || isAnew) {
      void this.operation.session.ask(); // It may have ended as well.
    }
    this.observeCause(log);
    this.notify();
  }

  /**
   * Only a status that has just come shows which server runs.
   *
   * @satisfies SWR-SESS-320
   */
  private observeServer(status: Status): void {
    const { login } = this;
    if (login === null || status === this.status) {
      return;
    }
    this.status = status;
    if (login.session.boot_id === status.boot_id) {
      login.servedAt = performance.now();
    } else {
      login.anewAt ??= performance.now();
    }
  }

  /** @satisfies SWR-SESS-035 */
  private observeSession(session: Session | null): void {
    const { login } = this;
    if (session === null || session === login?.session) {
      return;
    }
    if (session.is_open) {
      const servedAt = performance.now();
      const endsAt = servedAt + 1000 * secondsLeft(session);
      this.login = { session, endsAt, servedAt, anewAt: null };
      return;
    }
    if (login !== null && !this.operation.session.hasLeft) {
      this.logout = endOf(login, session.boot_id);
    }
    this.login = null;
  }

  /**
   * True when it was lost just now.
   *
   * @satisfies SWR-CON-091
   */
  private observeCommand({ authority }: Status): boolean {
    const own = this.operation.authority;
    const { taken, boot } = this;
    if (own.isMine(authority)) {
      this.taken ??= boot;
      return false;
    }
    this.taken = null;
    if (taken === null || own.left === "by hand") {
      return false;
    }
    const cause = taken === boot ? UNKNOWN : "the server was started anew";
    this.command = own.left === "hidden" ? "this page was hidden" : cause;
    return true;
  }

  /** The event may come after the state. */
  private observeCause(log: readonly LogEntry[]): void {
    const peer = String(this.operation.page.number);
    const last = log.find(
      ({ name, subject }) => name.startsWith("AUTHORITY_") && subject === peer,
    );
    if (this.command === UNKNOWN && last?.name === "AUTHORITY_LOST") {
      this.command = causes[last.value] ?? UNKNOWN;
    }
  }

  private notify(): void {
    const { command, logout } = this;
    const isBoth = command === causes[0] && logout !== null;
    const cause = isBoth ? "the session has ended" : command;
    const sentences = [
      ...(cause === null ? [] : [`Command lost: ${cause}.`]),
      ...(logout === null ? [] : [`Logged out: ${logout}.`]),
    ];
    if (sentences.join() !== this.sentences.join()) {
      this.sentences = sentences;
      this.listeners.forEach((listener) => listener());
    }
  }
}
