// SPDX-License-Identifier: Apache-2.0
// This page as what commands by HTTP: its number, drawn anew by each load of it, and the ids of what it does.
import type { Path, Problem } from "@interface";

const TIMEOUT_MS = 1500;
/** A repeated id repeats nothing, so what was not answered is asked again. */
const TRIES = 3;
const PAGE_HEADER = "X-Boresight-Page";
const TOKEN_HEADER = "X-Boresight-Token";

export type Method = "GET" | "POST" | "PUT" | "DELETE";

function drawNumber(): number {
  const [number = 0] = crypto.getRandomValues(new Uint32Array(1));
  return number === 0 ? 1 : number;
}

/** In words, with the axis and the limit that are why. */
export function refusalOf(problem: Partial<Problem>): string {
  const sentence = problem.detail ?? "It was refused.";
  if (problem.axis === undefined) {
    return sentence;
  }
  const limit = problem.limit === undefined ? "" : `, ${problem.limit} limit`;
  return `${sentence} (${problem.axis}${limit})`;
}

export class Page {
  readonly number = drawNumber();
  private readonly getToken: () => string | null;
  private acts = 0;

  constructor(getToken: () => string | null) {
    this.getToken = getToken;
  }

  /** Null once it was accepted or done; otherwise why not, for people. */
  async act(path: Path, fields: object): Promise<string | null> {
    this.acts += 1;
    const body = JSON.stringify({ id: this.acts, ...fields });
    for (let tries = 0; tries < TRIES; tries += 1) {
      try {
        const response = await this.request("POST", path, body);
        const answer = (await response.json()) as Partial<Problem>;
        return response.ok ? null : refusalOf(answer);
      } catch {
        // Asked again by the same id.
      }
    }
    return "The server does not answer.";
  }

  request(method: Method, path: Path, body?: string): Promise<Response> {
    const headers: Record<string, string> = {
      [PAGE_HEADER]: String(this.number),
      [TOKEN_HEADER]: this.getToken() ?? "",
    };
    if (body !== undefined) {
      headers["Content-Type"] = "application/json";
    }
    return fetch(path, {
      method,
      headers,
      body: body ?? null,
      keepalive: method === "DELETE",
      signal: AbortSignal.timeout(TIMEOUT_MS),
    });
  }
}
