// SPDX-License-Identifier: Apache-2.0
// A server and a clock that the tests are in charge of.
import type { Hello, LogEntry, RobotState } from "../api";
import type { Stream, Surroundings } from "../store";

type Listener = (event: MessageEvent<string>) => void;

export class FakeStream implements Stream {
  onerror: ((event: Event) => void) | null = null;
  isClosed = false;
  private readonly listeners = new Map<string, Listener>();

  addEventListener(type: string, listener: Listener): void {
    this.listeners.set(type, listener);
  }

  close(): void {
    this.isClosed = true;
  }

  send(type: "hello", data: Hello): void;
  send(type: "state", data: RobotState): void;
  send(type: "log", data: LogEntry): void;
  send(type: string, data: unknown): void {
    const event = new MessageEvent(type, { data: JSON.stringify(data) });
    this.listeners.get(type)?.(event as MessageEvent<string>);
  }

  fail(): void {
    this.onerror?.(new Event("error"));
  }
}

export class FakeSurroundings implements Surroundings {
  readonly streams: FakeStream[] = [];
  private time = 1000;

  /** The stream opened last. */
  get stream(): FakeStream {
    const stream = this.streams.at(-1);
    if (stream === undefined) {
      throw new Error("no stream has been opened");
    }
    return stream;
  }

  openStream(): Stream {
    this.streams.push(new FakeStream());
    return this.stream;
  }

  now(): number {
    return this.time;
  }

  pass(ms: number): void {
    this.time += ms;
  }
}
