// SPDX-License-Identifier: Apache-2.0
// The robot of a page with the server before it: served.wasm, as site/served/served.h has it, and the one browser that
// is logged in there. Nothing but these calls decides what it does: no clock, no chance, no network.
import type { Path, Session } from "@interface";
import type { StreamEvent } from "../transport/transport";
import { read, SceneHand, type HandModule } from "../what_if/scene_hand.ts";
import { SceneRun, type RobotModule } from "../what_if/scene_run.ts";
import type { Input, Vocabulary } from "../what_if/scene_text.ts";

function inputOf(line: string): Input {
  const colon = line.indexOf(":");
  const words = line.slice(colon + 1).split(",");
  return { cycle: Number(line.slice(0, colon)), words };
}

/** The exports of the module. */
interface Exports extends HandModule {
  textSize(): number;
  answer(): number;
  start(seed: number, utcS: number): number;
  step(cycles: number): void;
  ask(size: number): number;
  listen(): number;
  cycles(): number;
  journal(): number;
}

export interface Asked {
  method: string;
  address: string;
  headers: Readonly<Record<string, string>>;
  body: string | null;
}

export interface Answered {
  status: number;
  reason: string;
  headers: [string, string][];
  body: string;
}

export interface Reported {
  type: StreamEvent;
  data: string;
}

/** All that a robot is. */
export type Snapshot = Uint8Array<ArrayBuffer>;

const END_OF_LINE = "\r\n";
const END_OF_HEAD = END_OF_LINE + END_OF_LINE;
const HOST = "127.0.0.1";
const SESSION_PATH: Path = "/api/v1/session";
const TOKEN_HEADER = "X-Boresight-Token";
const JSON_TYPE = { "Content-Type": "application/json" };

function readAnswer(text: string): Answered {
  const end = text.indexOf(END_OF_HEAD);
  const [first = "", ...lines] = text.slice(0, end).split(END_OF_LINE);
  const [, status, reason = ""] = /^\S+ (\d+) ?(.*)$/.exec(first) ?? [];
  const headers = lines.map((line): [string, string] => {
    const colon = line.indexOf(": ");
    return [line.slice(0, colon), line.slice(colon + 2)];
  });
  const body = text.slice(end + END_OF_HEAD.length);
  return { status: Number(status), reason, headers, body };
}

function readTold(message: string): Reported {
  const [, type] = /^event: (.*)$/m.exec(message) ?? [];
  const [, data = ""] = /^data: (.*)$/m.exec(message) ?? [];
  return { type: type as StreamEvent, data };
}

export class ServedRobot {
  private readonly module: WebAssembly.Module;
  private readonly exported: Exports;
  private readonly hand: SceneHand;
  private cookie = "";
  private token = "";

  constructor(module: WebAssembly.Module) {
    const { exports } = new WebAssembly.Instance(module, {});
    this.module = module;
    this.exported = exports as unknown as Exports;
    this.hand = new SceneHand(this.exported);
  }

  /** The inputs that there are. */
  get vocabulary(): Vocabulary {
    return this.hand.vocabulary;
  }

  /** Does one input of a scene before the next cycle; throws when it is refused. */
  act(input: Input): void {
    this.hand.act(input);
  }

  /**
   * Starts the robot of that name, `utcS` being the time of the world, and logs in by the code of the first login.
   *
   * @satisfies SWR-SITE-010
   */
  start(robot: string, seed: number, utcS: number): void {
    this.write(`${robot}\0`);
    if (!this.call(() => this.exported.start(seed, utcS))) {
      throw new Error(`There is no robot “${robot}”.`);
    }
    const code = this.read(this.bytes(this.exported.answer()).indexOf(0));
    const { body } = this.ask({
      method: "POST",
      address: SESSION_PATH,
      headers: JSON_TYPE,
      body: JSON.stringify({ code }),
    });
    this.token = (JSON.parse(body) as Session).token ?? "";
  }

  /** The user of the page stays at the robot. */
  stay(): void {
    const headers = { [TOKEN_HEADER]: this.token };
    this.ask({ method: "PUT", address: SESSION_PATH, headers, body: null });
  }

  /**
   * Lets so many cycles pass.
   *
   * @satisfies SWR-SITE-021
   */
  step(cycles: number): void {
    this.call(() => this.exported.step(cycles));
  }

  /** As a browser asks, which keeps the cookie for itself. A request that waits for control lets cycles pass. */
  ask({ method, address, headers, body }: Asked): Answered {
    const bytes = new TextEncoder().encode(body ?? "");
    const fields = {
      Host: HOST,
      ...(this.cookie === "" ? {} : { Cookie: this.cookie }),
      ...headers,
      ...(body === null ? {} : { "Content-Length": String(bytes.length) }),
    };
    const lines = Object.entries(fields).map(
      ([name, value]) => `${END_OF_LINE}${name}: ${value}`,
    );
    const size = this.write(
      `${method} ${address} HTTP/1.1${lines.join("")}${END_OF_HEAD}${body ?? ""}`,
    );
    const answer = readAnswer(
      this.read(this.call(() => this.exported.ask(size))),
    );
    const set = answer.headers.find(([name]) => name === "Set-Cookie");
    this.cookie = set?.[1].split(";")[0] ?? this.cookie;
    return answer;
  }

  /** Messages of the stream since the last time. */
  listen(): Reported[] {
    const size = this.call(() => this.exported.listen());
    return this.read(size).split("\n\n").slice(0, -1).map(readTold);
  }

  /**
   * Inputs of its server since the last time; null: they are not known any more. They are not asked for before the first
   * cycle: each server gives the same ones then.
   */
  done(): Input[] | null {
    const place = this.exported.journal();
    const lines = place === 0 ? null : read(this.exported, place).split("\n");
    return (
      lines
        ?.slice(0, -1)
        .map(inputOf)
        .filter(({ cycle }) => cycle > 0) ?? null
    );
  }

  /** Since it was started. */
  get cycles(): number {
    return this.exported.cycles();
  }

  /** @satisfies SWR-SITE-016 */
  snapshot(): Snapshot {
    return this.bytes(0).slice();
  }

  /** Goes on from there. Memory that it has got since is as new. */
  restore(snapshot: Snapshot): void {
    this.bytes(0).fill(0).set(snapshot);
  }

  /** Another one that goes on from where this one is, and of which it knows nothing. */
  copy(): SceneRun {
    const { exports } = new WebAssembly.Instance(this.module, {});
    const exported = exports as unknown as Exports & RobotModule;
    const run = new SceneRun({ ...exported, step: () => exported.step(1) });
    const { cycles: cycle } = this;
    run.restore({
      memory: this.snapshot(),
      cycle,
      commands: this.hand.commands,
    });
    return run;
  }

  private bytes(address: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.exported.memory.buffer, address);
  }

  /** Returns how many bytes it is. */
  private write(words: string): number {
    const bytes = new TextEncoder().encode(words);
    if (bytes.length > this.exported.textSize()) {
      throw new Error("The request is too long.");
    }
    this.bytes(this.exported.text()).set(bytes);
    return bytes.length;
  }

  private read(size: number): string {
    const bytes = this.bytes(this.exported.answer()).subarray(0, size);
    return new TextDecoder().decode(bytes);
  }

  /** A contract that is broken has left its name in the text. */
  private call<Result>(act: () => Result): Result {
    try {
      return act();
    } catch {
      const bytes = this.bytes(this.exported.text());
      throw new Error(
        new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0))),
      );
    }
  }
}
