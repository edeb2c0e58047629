// SPDX-License-Identifier: Apache-2.0
// The user who is logged in at the server. The cookie is out of reach of any script; the token is kept in this page's memory.
import { Session } from "@interface";
import type { LoginRequest, Path, Problem } from "@interface";
import { transport } from "@transport";
import { fitted } from "../words/shape";

const SESSION_PATH: Path = "/api/v1/session";
/** Asking makes no session longer; another tab may have ended or renewed it. */
export const ASK_MS = 10_000;
const TIMEOUT_MS = 5000;
const TOKEN_HEADER = "X-Boresight-Token";

export interface SessionView {
  /** Null before the first answer. */
  session: Session | null;
  /** Why the last thing that was asked for was not done. */
  problem: string | null;
}

type Method = "GET" | "POST" | "PUT" | "DELETE";

async function reasonOf(response: Response): Promise<string> {
  const answer = (await response.json()) as Partial<Problem>;
  return answer.detail ?? response.statusText;
}

async function readSession(response: Response): Promise<Session> {
  return fitted(await response.json(), Session, SESSION_PATH);
}

/** Seconds until the session ends unless it is renewed. */
export function secondsLeft(session: Session): number {
  return Math.min(session.idle_s, session.most_s);
}

/** It ends soon. */
export function isEnding(session: Session): boolean {
  return session.is_open && secondsLeft(session) <= session.warn_s;
}

export class SessionStore {
  private readonly listeners = new Set<() => void>();
  private view: SessionView = { session: null, problem: null };
  private timer: ReturnType<typeof setInterval> | null = null;
  /** This page has logged out itself. */
  hasLeft = false;

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  readonly getView = (): SessionView => this.view;

  start(): void {
    void this.ask();
    this.timer = setInterval(() => void this.ask(), ASK_MS);
  }

  stop(): void {
    if (this.timer !== null) {
      clearInterval(this.timer);
    }
  }

  logIn(request: LoginRequest): Promise<void> {
    this.hasLeft = false;
    return this.send("POST", request);
  }

  renew(): Promise<void> {
    return this.send("PUT");
  }

  logOut(): Promise<void> {
    this.hasLeft = true;
    return this.send("DELETE");
  }

  async ask(): Promise<void> {
    try {
      const response = await this.request("GET");
      if (response.ok) {
        this.replace({ session: await readSession(response) });
      }
    } catch {
      // The rest of the page says that the server does not answer.
    }
  }

  private async send(method: Method, body?: LoginRequest): Promise<void> {
    try {
      const response = await this.request(method, body);
      if (response.ok) {
        const session = await readSession(response);
        this.replace({ session, problem: null });
      } else {
        this.replace({ problem: await reasonOf(response) });
        await this.ask();
      }
    } catch {
      this.replace({ problem: "The server does not answer." });
    }
  }

  private request(method: Method, body?: LoginRequest): Promise<Response> {
    const headers: Record<string, string> = {};
    if (body !== undefined) {
      headers["Content-Type"] = "application/json";
    }
    const token = this.view.session?.token ?? null;
    if (method !== "GET" && token !== null) {
      headers[TOKEN_HEADER] = token;
    }
    return transport.request(SESSION_PATH, {
      method,
      headers,
      body: body === undefined ? null : JSON.stringify(body),
      signal: AbortSignal.timeout(TIMEOUT_MS),
    });
  }

  private replace(change: Partial<SessionView>): void {
    this.view = { ...this.view, ...change };
    this.listeners.forEach((listener) => listener());
  }
}
