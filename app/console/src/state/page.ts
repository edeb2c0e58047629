// SPDX-License-Identifier: Apache-2.0
// This page as what commands by HTTP: its number, drawn anew by each load of it, and the ids of what it does.
import type { Act, Path, Problem } from "@interface";
import { transport } from "@transport";
import { RecentActs } from "./acts";
import { NO_ANSWER, refusalOf } from "./refusal";

export { refusalOf } from "./refusal";

const TIMEOUT_MS = 1500;
const JSON_TYPE = "application/json";
/** A repeated id repeats nothing, so what was not answered is asked again. */
const TRIES = 3;
const PAGE_HEADER = "X-Boresight-Page";
const TOKEN_HEADER = "X-Boresight-Token";

/** A path, and what is asked of it. */
export type Address = Path | `${Path}?${string}`;
export type Method = "GET" | "POST" | "PUT" | "DELETE";

function drawNumber(): number {
  const [number = 0] = crypto.getRandomValues(new Uint32Array(1));
  return number === 0 ? 1 : number;
}

/** The options of a request. */
export interface RequestOptions {
  body?: string;
  type?: string;
  timeoutMs?: number;
}

/** Answer of the server to a request that is no act: one of the two. */
export interface Reply<Answer> {
  answer: Answer | null;
  problem: Partial<Problem> | null;
}

export class Page {
  readonly number = drawNumber();
  readonly recentActs = new RecentActs(this.number);
  private readonly getToken: () => string | null;
  private acts = 0;

  constructor(getToken: () => string | null) {
    this.getToken = getToken;
  }

  /** Null once it was accepted or done; otherwise why not, for people. */
  async act(path: Path, fields: object): Promise<string | null> {
    this.acts += 1;
    const id = this.acts;
    this.recentActs.begin(id, path, fields);
    const refusal = await this.ask(id, path, fields);
    if (refusal !== null) {
      this.recentActs.fail(id, refusal);
    }
    return refusal;
  }

  request(method: Method, path: Address, body?: string): Promise<Response> {
    return this.send(method, path, body === undefined ? {} : { body });
  }

  /** For what is no act: a question, or something that may be repeated without harm. */
  async exchange<Answer>(
    method: Method,
    path: Path,
    options: RequestOptions = {},
  ): Promise<Reply<Answer>> {
    try {
      const response = await this.send(method, path, options);
      const said: unknown = await response.json();
      return response.ok
        ? { answer: said as Answer, problem: null }
        : { answer: null, problem: said as Partial<Problem> };
    } catch {
      return { answer: null, problem: { detail: NO_ANSWER } };
    }
  }

  private async ask(id: number, path: Path, fields: object) {
    const body = JSON.stringify({ id, ...fields });
    for (let tries = 0; tries < TRIES; tries += 1) {
      try {
        const response = await this.send("POST", path, { body });
        const said = (await response.json()) as Partial<Problem & Act>;
        if (!response.ok) {
          return refusalOf(said);
        }
        this.recentActs.answer(
          id,
          said.state === "accepted" ? "accepted" : "done",
        );
        return null;
      } catch {
        // Asked again by the same id.
      }
    }
    return NO_ANSWER;
  }

  private send(
    method: Method,
    path: Address,
    { body, type = JSON_TYPE, timeoutMs = TIMEOUT_MS }: RequestOptions,
  ): Promise<Response> {
    const headers: Record<string, string> = {
      [PAGE_HEADER]: String(this.number),
      [TOKEN_HEADER]: this.getToken() ?? "",
    };
    if (body !== undefined) {
      headers["Content-Type"] = type;
    }
    return transport.request(path, {
      method,
      headers,
      body: body ?? null,
      keepalive: method === "DELETE",
      signal: AbortSignal.timeout(timeoutMs),
    });
  }
}
