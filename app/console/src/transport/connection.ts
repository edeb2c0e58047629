// SPDX-License-Identifier: Apache-2.0
// The one connection to the server's stream, and the tabs that share it. Runs in a shared worker, or in the page where
// there is none.
import type { Path, Problem } from "@interface";
import {
  LOG_LENGTH,
  streamEvents,
  type StreamEvent,
  type StreamListener,
} from "./transport";

/** The part of EventSource that is used. */
export interface Source {
  addEventListener(
    type: string,
    listener: (event: MessageEvent<string>) => void,
  ): void;
  onerror: ((event: Event) => void) | null;
  close(): void;
}

export interface Network {
  openSource(): Source;
  /** Why the server refuses the stream; null when it cannot be reached or does not refuse. */
  askReason(): Promise<string | null>;
}

const EVENTS_PATH: Path = "/api/v1/events";
const REASON_TIMEOUT_MS = 1000;

async function askReason(): Promise<string | null> {
  const abort = new AbortController();
  const timer = setTimeout(() => abort.abort(), REASON_TIMEOUT_MS);
  try {
    const response = await fetch(EVENTS_PATH, { signal: abort.signal });
    return response.ok
      ? null
      : (((await response.json()) as Partial<Problem>).detail ?? null);
  } catch {
    return null;
  } finally {
    clearTimeout(timer);
    abort.abort();
  }
}

export const browserNetwork: Network = {
  openSource: () => new EventSource(EVENTS_PATH),
  askReason,
};

/**
 * Opens the stream for the first tab, closes it after the last one, and gives a later tab the messages of the others.
 * The state is not among them: it may be old, and a new one comes immediately.
 *
 * @satisfies SWR-CON-006
 */
export class Connection {
  private readonly tabs = new Set<StreamListener>();
  private readonly network: Network;
  private source: Source | null = null;
  private hello: string | null = null;
  private log: string[] = [];

  constructor(network: Network = browserNetwork) {
    this.network = network;
  }

  join(tab: StreamListener): void {
    this.tabs.add(tab);
    if (this.source === null) {
      this.open();
    } else {
      this.greet(tab);
    }
  }

  leave(tab: StreamListener): void {
    if (this.tabs.delete(tab) && this.tabs.size === 0) {
      this.close();
    }
  }

  private open(): void {
    const source = this.network.openSource();
    for (const type of streamEvents) {
      source.addEventListener(type, (event) => this.send(type, event.data));
    }
    source.onerror = () => void this.lose();
    this.source = source;
  }

  private close(): void {
    this.source?.close();
    this.source = null;
    this.hello = null;
    this.log = [];
  }

  private greet(tab: StreamListener): void {
    if (this.hello !== null) {
      tab.hear("hello", this.hello);
    }
    this.log.forEach((entry) => tab.hear("log", entry));
  }

  private send(type: StreamEvent, data: string): void {
    if (type === "hello") {
      this.hello = data;
    } else if (type === "log") {
      this.log = [...this.log, data].slice(-LOG_LENGTH);
    }
    this.tabs.forEach((tab) => tab.hear(type, data));
  }

  /** The browser does not say why a stream was refused; the server does, when asked once more. */
  private async lose(): Promise<void> {
    const lost = [...this.tabs];
    const wasOpen = this.hello !== null;
    this.tabs.clear();
    this.close();
    const reason = wasOpen ? null : await this.network.askReason();
    lost.forEach((tab) => tab.lose(reason));
  }
}
