// SPDX-License-Identifier: Apache-2.0
// A server and a clock that the tests are in charge of.
import type { Act, Hello, LogEntry, RobotState } from "@interface";
import type { Surroundings } from "../state/store";
import type {
  Stream,
  StreamEvent,
  StreamListener,
} from "../transport/transport";

export class FakeStream implements Stream {
  isClosed = false;
  private readonly listener: StreamListener;

  constructor(listener: StreamListener) {
    this.listener = listener;
  }

  close(): void {
    this.isClosed = true;
  }

  send(type: "hello", data: Hello): void;
  send(type: "state", data: RobotState): void;
  send(type: "log", data: LogEntry): void;
  send(type: "act", data: Act): void;
  send(type: StreamEvent, data: unknown): void {
    this.listener.hear(type, JSON.stringify(data));
  }

  fail(reason: string | null = null): void {
    this.listener.lose(reason);
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

  openStream(listener: StreamListener): Stream {
    this.streams.push(new FakeStream(listener));
    return this.stream;
  }

  now(): number {
    return this.time;
  }

  pass(ms: number): void {
    this.time += ms;
  }
}
