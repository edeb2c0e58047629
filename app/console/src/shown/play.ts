// SPDX-License-Identifier: Apache-2.0
// A robot of build/site/served.wasm with the server before it, led by acts that are data. Its time is that of its cycles.
import { readFileSync } from "node:fs";
import type { Modes, RobotState } from "@interface";
import { ServedRobot, type Snapshot } from "../site/served_robot.ts";

/** Root of the repository. */
export const ROOT = `${import.meta.dirname}/../../../..`;
const SEED = 7;
const UTC_S = 1_790_000_000;
/** A page renews authority, and its hold of the box. */
const RENEW_CYCLES = 500;
/** Against hanging. */
const MOST_CYCLES = 120_000;
/** Number of the page that asks for answers beside the state. */
export const PAGE_NUMBER = 7;

type Body = Record<string, unknown>;

/** `order`: words of a scene (what_if/scene_text.ts). `until`: a field of the state is what `is` says. */
export type Act =
  | { order: string }
  | { post: string; body?: Body }
  | { delete: string }
  | { wait: number }
  | { until: string; is: unknown }
  | { unheld: boolean };

export interface Kept {
  memory: Snapshot;
  acts: number;
  isHeld: boolean;
}

/** The values at a place such as `status.cards[].link`. Nothing has null for all that it could have. */
export function valuesAt(state: unknown, place: string): unknown[] {
  return place.split(".").reduce<unknown[]>(
    (found, step) => {
      const name = step.replace("[]", "");
      const values = found.map(
        (one) => (one as Body | null | undefined)?.[name] ?? null,
      );
      return step.endsWith("[]") ? values.flat() : values;
    },
    [state],
  );
}

export class Play {
  private readonly robot: ServedRobot;
  private token = "";
  private acts = 0;
  /** Authority and what is held at the box are renewed. */
  private isHeld = true;

  constructor(module: WebAssembly.Module, robot: string) {
    this.robot = new ServedRobot(module);
    this.robot.start(robot, SEED, UTC_S);
    this.robot.step(1);
    this.token = this.read<{ token: string }>("session").token;
    this.robot.ask(this.request("GET", "/api/v1/events"));
  }

  static readonly module = () =>
    new WebAssembly.Module(readFileSync(`${ROOT}/build/site/served.wasm`));

  get cycles(): number {
    return this.robot.cycles;
  }

  keep(): Kept {
    const { acts, isHeld } = this;
    return { memory: this.robot.snapshot(), acts, isHeld };
  }

  goBack({ memory, acts, isHeld }: Kept): void {
    this.robot.restore(memory);
    this.acts = acts;
    this.isHeld = isHeld;
  }

  /** Lets so many cycles pass. */
  step(cycles: number): void {
    let left = cycles;
    while (left > 0) {
      const part = Math.min(left, RENEW_CYCLES - (this.cycles % RENEW_CYCLES));
      this.robot.step(part);
      left -= part;
      if (this.isHeld && this.cycles % RENEW_CYCLES === 0) {
        this.robot.ask(this.request("PUT", "/api/v1/authority"));
        this.robot.ask(this.request("PUT", "/api/v1/box"));
      }
    }
  }

  /** Returns why it was refused, or null. */
  do(act: Act): string | null {
    if ("order" in act) {
      const words = act.order.split(/[ ,]/);
      this.robot.act({ cycle: this.cycles, words });
      return null;
    }
    if ("wait" in act) {
      this.step(act.wait);
      return null;
    }
    if ("until" in act) {
      return this.wait(act.until, act.is);
    }
    if ("unheld" in act) {
      this.isHeld = !act.unheld;
      return null;
    }
    return "post" in act
      ? this.post(act.post, act.body ?? {})
      : this.refusal("DELETE", `/api/v1/${act.delete}`);
  }

  /** All of them must be done. */
  doAll(acts: readonly Act[]): void {
    for (const act of acts) {
      const refusal = this.do(act);
      if (refusal !== null) {
        throw new Error(`${JSON.stringify(act)}: ${refusal}`);
      }
    }
  }

  state(): RobotState {
    return {
      status: this.read("status"),
      motors: this.read("motors"),
      targeting: this.read("targeting"),
    };
  }

  outlook(): Modes {
    return this.read("modes");
  }

  /** Messages of the stream since the last time. */
  listen() {
    return this.robot.listen();
  }

  /** As a page asks. */
  fetch(address: string, options: RequestInit): Response {
    const { status, headers, body } = this.robot.ask({
      method: options.method ?? "GET",
      address,
      headers: Object.fromEntries(new Headers(options.headers)),
      body: (options.body ?? null) as string | null,
    });
    const isBare = status === 204 || status === 304;
    return new Response(isBare ? null : body, { status, headers });
  }

  private wait(place: string, is: unknown): string | null {
    for (let waited = 0; waited < MOST_CYCLES; waited += RENEW_CYCLES) {
      if (valuesAt(this.state(), place).includes(is)) {
        return null;
      }
      this.step(RENEW_CYCLES);
    }
    return "it has not come";
  }

  private post(path: string, body: Body): string | null {
    this.acts += 1;
    const isAct = path !== "box" && path !== "stop";
    return this.refusal(
      "POST",
      `/api/v1/${path}`,
      isAct ? { id: this.acts, ...body } : body,
    );
  }

  private refusal(method: string, address: string, body?: Body) {
    const answered = this.robot.ask(this.request(method, address, body));
    return answered.status < 300 ? null : answered.body;
  }

  private read<Answer>(path: string): Answer {
    const asked = this.request("GET", `/api/v1/${path}`);
    return JSON.parse(this.robot.ask(asked).body) as Answer;
  }

  private request(method: string, address: string, body?: Body) {
    const headers: Record<string, string> = {
      "X-Boresight-Page": String(PAGE_NUMBER),
      "X-Boresight-Token": this.token,
      ...(body === undefined ? {} : { "Content-Type": "application/json" }),
    };
    const text = body === undefined ? null : JSON.stringify(body);
    return { method, address, headers, body: text };
  }
}
