// SPDX-License-Identifier: Apache-2.0
import { Act, Hello, LogEntry, RobotState } from "@interface";
import { transport } from "@transport";
import type { ActListener } from "./acts";
import { freshnessOf, type Freshness } from "./freshness";
import { fitted, Misfit, watchMisfits } from "../words/shape";
import { Trace } from "../words/trace";
import {
  LOG_LENGTH,
  type Stream,
  type StreamEvent,
  type StreamListener,
} from "../transport/transport";

const CHECK_MS = 100;
const RECONNECT_MS = 500;
/** A stream that has brought data and then nothing for so long is opened again. */
const SILENCE_MS = 3000;

/** All that the panels show. Never changed, only replaced. */
export interface ConsoleView {
  isConnected: boolean;
  /** Why there is no stream, if the server has said so. */
  refusal: string | null;
  freshness: Freshness;
  /** Age of the data: control's share and the time since it arrived. */
  ageMs: number;
  /** The server is of another build than this page, or sends what the page cannot read. */
  isOutdated: boolean;
  /** The place in a message by which that was noticed. */
  misfit?: string;
  robot: RobotState | null;
  /** Newest first. */
  log: readonly LogEntry[];
}

export interface Surroundings {
  openStream(listener: StreamListener): Stream;
  now(): number;
}

export const browserSurroundings: Surroundings = {
  openStream: transport.openStream,
  now: () => performance.now(),
};

/**
 * The one store: listens to the server and notices when it falls silent.
 *
 * @satisfies SWR-CON-011
 * @satisfies SWR-CON-098
 */
export class TelemetryStore implements StreamListener {
  /** For what is drawn. */
  readonly trace = new Trace();
  private readonly listeners = new Set<() => void>();
  private readonly actListeners = new Set<ActListener>();
  private readonly surroundings: Surroundings;
  private stream: Stream | null = null;
  private unwatch: (() => void) | null = null;
  private timer: ReturnType<typeof setInterval> | null = null;
  private arrivedAt = 0;
  private heardAt = 0;
  private closedAt = 0;
  private buildId: string | null = null;
  private view: ConsoleView = {
    isConnected: false,
    refusal: null,
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

  /** Until what is returned is called. */
  tellActsTo(listener: ActListener): () => void {
    this.actListeners.add(listener);
    return () => this.actListeners.delete(listener);
  }

  start(): void {
    this.unwatch = watchMisfits((place) => this.distrust(place));
    this.open();
    this.timer = setInterval(() => this.check(), CHECK_MS);
  }

  stop(): void {
    if (this.timer !== null) {
      clearInterval(this.timer);
    }
    this.unwatch?.();
    this.stream?.close();
    this.stream = null;
  }

  hear(type: StreamEvent, data: string): void {
    this.heardAt = this.surroundings.now();
    try {
      this.read(type, data);
    } catch (failure) {
      if (!(failure instanceof Misfit)) {
        this.distrust(type);
      }
    }
  }

  /** A browser does not always reconnect by itself; this does. */
  lose(reason: string | null): void {
    this.stream?.close();
    this.stream = null;
    this.closedAt = this.surroundings.now();
    this.actListeners.forEach((listener) => listener.loseActs());
    this.replace({ isConnected: false, refusal: reason, freshness: "stale" });
  }

  private open(): void {
    this.heardAt = this.surroundings.now();
    this.stream = this.surroundings.openStream(this);
  }

  private read(type: StreamEvent, data: string): void {
    switch (type) {
      case "hello":
        return this.greet(fitted(JSON.parse(data), Hello, type));
      case "state":
        return this.take(fitted(JSON.parse(data), RobotState, type));
      case "log":
        return this.note(fitted(JSON.parse(data), LogEntry, type));
      case "act":
        return this.tellAct(fitted(JSON.parse(data), Act, type));
    }
  }

  /** @satisfies SWR-CON-043 */
  private greet(hello: Hello): void {
    this.buildId ??= hello.build_id;
    this.replace({
      isConnected: true,
      refusal: null,
      isOutdated:
        this.buildId !== hello.build_id || this.view.misfit !== undefined,
      log: [],
    });
  }

  private take(robot: RobotState): void {
    this.arrivedAt = this.surroundings.now();
    this.trace.take(robot, this.arrivedAt, this.view.log);
    this.replace({ isConnected: true, robot, ...this.judge(robot, true) });
  }

  /** A message that cannot be read is not used at all. */
  private distrust(place: string): void {
    this.replace({ isOutdated: true, misfit: this.view.misfit ?? place });
  }

  private note(entry: LogEntry): void {
    this.replace({ log: [entry, ...this.view.log].slice(0, LOG_LENGTH) });
  }

  private tellAct(act: Act): void {
    this.actListeners.forEach((listener) => listener.hearAct(act));
  }

  private check(): void {
    const now = this.surroundings.now();
    if (this.stream === null && now - this.closedAt >= RECONNECT_MS) {
      this.open();
    } else if (this.isSilent(now)) {
      this.lose(null);
    }
    if (this.view.robot !== null) {
      this.replace(this.judge(this.view.robot, this.view.isConnected));
    }
  }

  private isSilent(now: number): boolean {
    return (
      this.stream !== null &&
      this.view.robot !== null &&
      now - this.heardAt >= SILENCE_MS
    );
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
