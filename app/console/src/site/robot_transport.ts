// SPDX-License-Identifier: Apache-2.0
// The robot in a worker of this page, reached as the one behind a server is.
import type { Path, Problem } from "@interface";
import type { Stream, StreamListener, Transport } from "../transport/transport";
import type { Comparison, Identity, Order, Report } from "./messages";
import type { Question } from "./question";
import type { Answered, Asked } from "./served_robot";

const STOP_PATH: Path = "/api/v1/stop";
const EVENTS_PATH: Path = "/api/v1/events";
const BODILESS = [204, 304];

/** The part of a Worker that is used. */
export interface RobotPort {
  onmessage: ((event: MessageEvent<Report>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  postMessage(order: Order): void;
}

/** Further values that the page shows of it. Never changed, only replaced. */
export interface RobotView {
  /** Null before it is started. */
  identity: Identity | null;
  cycles: number;
  /** To which cycle one may go, and how many inputs are forgotten when time goes on from here. */
  end: number;
  later: number;
  /** The inputs until a cycle, or why they are not given. Null: not asked for. */
  shared: Extract<Report, { kind: "shared" | "unshared" }> | null;
  /** The inputs that there are. */
  inputs: readonly string[];
  /** Null: nothing was asked. */
  compared: Comparison | null;
  /** Share of the world's time. */
  share: number;
  /** Why there is no robot any more. */
  failure: string | null;
  /** It is what the link says, and not the robot. */
  isRefused: boolean;
}

interface Waiting {
  resolve(answered: Answered): void;
  reject(reason: Error): void;
}

function responseOf({ status, reason, headers, body }: Answered): Response {
  return new Response(BODILESS.includes(status) ? null : body, {
    status,
    statusText: reason,
    headers,
  });
}

function whenAborted(signal: AbortSignal): Promise<never> {
  return new Promise((_, reject) => {
    const abort = () => reject(signal.reason as Error);
    if (signal.aborted) {
      abort();
    }
    signal.addEventListener("abort", abort, { once: true });
  });
}

/** @satisfies SWR-SITE-011 */
export class RobotTransport implements Transport {
  private readonly port: RobotPort;
  private readonly listeners = new Set<() => void>();
  private readonly waiting = new Map<number, Waiting>();
  private asks = 0;
  private streamListener: StreamListener | null = null;
  private view: RobotView = {
    identity: null,
    cycles: 0,
    end: 0,
    later: 0,
    shared: null,
    inputs: [],
    compared: null,
    share: 1,
    failure: null,
    isRefused: false,
  };

  constructor(port: RobotPort, start: Extract<Order, { kind: "start" }>) {
    this.port = port;
    port.onmessage = ({ data }) => this.take(data);
    port.onerror = ({ message }) => this.fail(message);
    port.postMessage(start);
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  readonly getView = (): RobotView => this.view;

  /** How fast it lives: 1 as the world does, 0 not at all. */
  setPace(share: number): void {
    this.port.postMessage({ kind: "pace", share });
    this.replace({ share });
  }

  /** Lets one cycle pass. */
  step(): void {
    this.port.postMessage({ kind: "step" });
  }

  /** Back to a cycle, or as far forth as it has been; there time stands still. */
  goTo(cycle: number): void {
    this.port.postMessage({ kind: "go", cycle });
    this.replace({ share: 0 });
  }

  /** Asks for what was done until now. */
  shareCourse(): void {
    this.port.postMessage({ kind: "share" });
  }

  /** Asks what would be if, where time stands still. */
  compare(question: Question): void {
    this.port.postMessage({ kind: "compare", question });
  }

  readonly request = async (
    address: string,
    { method = "GET", headers, body, signal }: RequestInit,
  ): Promise<Response> => {
    const answered = this.ask({
      method,
      address,
      headers: Object.fromEntries(new Headers(headers)),
      body: (body ?? null) as string | null,
    });
    return responseOf(
      await (signal ? Promise.race([answered, whenAborted(signal)]) : answered),
    );
  };

  /** There is one page, and it listens once. */
  readonly openStream = (listener: StreamListener): Stream => {
    const close = () => {
      if (this.streamListener === listener) {
        this.streamListener = null;
      }
    };
    this.streamListener = listener;
    void this.request(EVENTS_PATH, {}).then(
      async (response) => {
        if (!response.ok) {
          const { detail } = (await response.json()) as Partial<Problem>;
          this.lose(detail ?? null);
        }
      },
      () => this.lose(this.view.failure),
    );
    return { close };
  };

  readonly stopAddresses = (): string[] => [STOP_PATH];

  private ask(asked: Asked): Promise<Answered> {
    if (this.view.failure !== null) {
      return Promise.reject(new Error(this.view.failure));
    }
    this.asks += 1;
    const id = this.asks;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.port.postMessage({ kind: "ask", id, asked });
    });
  }

  private take(report: Report): void {
    switch (report.kind) {
      case "started":
        return this.replace({ identity: report, inputs: report.inputs });
      case "answer":
        this.waiting.get(report.id)?.resolve(report.answered);
        this.waiting.delete(report.id);
        return;
      case "reported":
        return this.streamListener?.hear(report.type, report.data);
      case "time":
        return this.replace({
          cycles: report.cycles,
          end: report.end,
          later: report.later,
        });
      case "restarted":
        this.replace({ share: 0 });
        if (this.streamListener !== null) {
          this.openStream(this.streamListener);
        }
        return;
      case "shared":
      case "unshared":
        return this.replace({ shared: report });
      case "compared":
        return this.replace({ compared: report });
      case "refused":
        this.replace({ isRefused: true });
        return this.fail(report.reason);
      case "failed":
        return this.fail(report.reason);
    }
  }

  private fail(failure: string): void {
    this.replace({ failure });
    this.waiting.forEach(({ reject }) => reject(new Error(failure)));
    this.waiting.clear();
    this.lose(failure);
  }

  private lose(reason: string | null): void {
    const listener = this.streamListener;
    this.streamListener = null;
    listener?.lose(reason);
  }

  private replace(change: Partial<RobotView>): void {
    this.view = { ...this.view, ...change };
    this.listeners.forEach((listener) => listener());
  }
}
