// SPDX-License-Identifier: Apache-2.0
// How a page gets the stream: from the worker that all tabs share, or by itself where there is none or it is dead.
import { Connection } from "./connection";
import {
  streamEvents,
  type Stream,
  type StreamEvent,
  type StreamListener,
} from "./transport";

/** Messages from the worker to a tab. */
export type WorkerMessage =
  | { type: "joined" }
  | { type: StreamEvent; data: string }
  | { type: "lost"; reason: string | null };

/** From a tab to the worker; `ready` after each message. */
export type TabMessage = "ready" | "leave";

/** The part of a MessagePort that is used. */
export interface Port {
  onmessage: ((event: MessageEvent<WorkerMessage>) => void) | null;
  postMessage(message: TabMessage): void;
  close(): void;
}

/** A worker that has not even greeted for so long may be dead: the tab has a connection of its own until it greets. */
export const GREETING_MS = 2000;

function startWorker(onFailure: () => void): Port {
  const worker = new SharedWorker(
    new URL("./stream_worker.ts", import.meta.url),
    { type: "module", name: "boresight-stream" },
  );
  worker.onerror = onFailure;
  return worker.port;
}

/** Listens to the stream by the shared worker, and by a connection of its own as long as there is none. */
export class SharedStream implements Stream {
  private readonly listener: StreamListener;
  private readonly openAlone: () => Connection;
  private port: Port | null = null;
  private alone: Connection | null = null;
  private timer: ReturnType<typeof setTimeout> | null = null;
  private isClosed = false;

  constructor(
    listener: StreamListener,
    start: (onFailure: () => void) => Port = startWorker,
    openAlone: () => Connection = () => new Connection(),
  ) {
    this.listener = listener;
    this.openAlone = openAlone;
    try {
      this.port = start(() => this.doWithout());
      this.port.onmessage = (event) => this.take(event.data);
      this.timer = setTimeout(() => this.openOwn(), GREETING_MS);
    } catch {
      this.openOwn(); // Not supported, or refused with the storage.
    }
  }

  close(): void {
    this.isClosed = true;
    this.leaveWorker();
    this.closeOwn();
  }

  private leaveWorker(): void {
    this.stopTimer();
    this.port?.postMessage("leave");
    this.port?.close();
    this.port = null;
  }

  private stopTimer(): void {
    if (this.timer !== null) {
      clearTimeout(this.timer);
      this.timer = null;
    }
  }

  private doWithout(): void {
    this.leaveWorker();
    this.openOwn();
  }

  private openOwn(): void {
    if (!this.isClosed && this.alone === null) {
      this.alone = this.openAlone();
      this.alone.join(this.listener);
    }
  }

  private closeOwn(): void {
    this.alone?.leave(this.listener);
    this.alone = null;
  }

  private take(message: WorkerMessage): void {
    this.stopTimer();
    if (this.port === null) {
      return;
    }
    if (message.type === "joined") {
      this.closeOwn(); // The worker was slow, as on a busy machine.
    } else if (message.type === "lost") {
      this.listener.lose(message.reason);
    } else if (streamEvents.includes(message.type)) {
      this.listener.hear(message.type, message.data);
      this.port.postMessage("ready");
    }
  }
}
