// SPDX-License-Identifier: Apache-2.0
import type { Hello, LogEntry, RobotState } from "./api";
import { freshnessOf, type Freshness } from "./freshness";

export const LOG_LENGTH = 50;
const CHECK_MS = 100;
const RECONNECT_MS = 500;

/** All that the panels show. Never changed, only replaced. */
export interface ConsoleView {
  isConnected: boolean;
  freshness: Freshness;
  /** Age of the data: control's share and the time since it arrived. */
  ageMs: number;
  /** The server is of another build than this page. */
  isOutdated: boolean;
  robot: RobotState | null;
  /** Newest first. */
  log: readonly LogEntry[];
}

/** The part of EventSource that is used. */
export interface Stream {
  addEventListener(
    type: string,
    listener: (event: MessageEvent<string>) => void,
  ): void;
  onerror: ((event: Event) => void) | null;
  close(): void;
}

export interface Surroundings {
  openStream(): Stream;
  now(): number;
}

export const browserSurroundings: Surroundings = {
  openStream: () => new EventSource("/api/v1/events") as unknown as Stream,
  now: () => performance.now(),
};

/** The one store: listens to the server and notices when it falls silent. */
export class TelemetryStore {
  private readonly listeners = new Set<() => void>();
  private readonly surroundings: Surroundings;
  private stream: Stream | null = null;
  private timer: ReturnType<typeof setInterval> | null = null;
  private arrivedAt = 0;
  private closedAt = 0;
  private buildId: string | null = null;
  private view: ConsoleView = {
    isConnected: false,
    freshness: "stale",
    ageMs: 0,
    isOutdated: false,
    robot: null,
    log: [],
  };

  constructor(surroundings: Surroundings = browserSurroundings) {
    this.surroundings = surroundings;
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  readonly getView = (): ConsoleView => this.view;

  start(): void {
    this.open();
    this.timer = setInterval(() => this.check(), CHECK_MS);
  }

  stop(): void {
    if (this.timer !== null) {
      clearInterval(this.timer);
    }
    this.stream?.close();
    this.stream = null;
  }

  private open(): void {
    const stream = this.surroundings.openStream();
    stream.addEventListener("hello", (event) => {
      this.greet(JSON.parse(event.data) as Hello);
    });
    stream.addEventListener("state", (event) => {
      this.take(JSON.parse(event.data) as RobotState);
    });
    stream.addEventListener("log", (event) => {
      this.note(JSON.parse(event.data) as LogEntry);
    });
    stream.onerror = () => this.lose();
    this.stream = stream;
  }

  private greet(hello: Hello): void {
    this.buildId ??= hello.build_id;
    this.replace({
      isConnected: true,
      isOutdated: this.buildId !== hello.build_id,
      log: [],
    });
  }

  private take(robot: RobotState): void {
    this.arrivedAt = this.surroundings.now();
    this.replace({ isConnected: true, robot, ...this.judge(robot, true) });
  }

  private note(entry: LogEntry): void {
    this.replace({ log: [entry, ...this.view.log].slice(0, LOG_LENGTH) });
  }

  /** A browser does not always reconnect by itself; this does. */
  private lose(): void {
    this.stream?.close();
    this.stream = null;
    this.closedAt = this.surroundings.now();
    this.replace({ isConnected: false, freshness: "stale" });
  }

  private check(): void {
    const now = this.surroundings.now();
    if (this.stream === null && now - this.closedAt >= RECONNECT_MS) {
      this.open();
    }
    if (this.view.robot !== null) {
      this.replace(this.judge(this.view.robot, this.view.isConnected));
    }
  }

  private judge(
    robot: RobotState,
    isConnected: boolean,
  ): Pick<ConsoleView, "ageMs" | "freshness"> {
    const silenceMs = this.surroundings.now() - this.arrivedAt;
    const ageMs = Math.round(robot.status.age_ms + silenceMs);
    return { ageMs, freshness: isConnected ? freshnessOf(ageMs) : "stale" };
  }

  private replace(change: Partial<ConsoleView>): void {
    this.view = { ...this.view, ...change };
    this.listeners.forEach((listener) => listener());
  }
}
