// SPDX-License-Identifier: Apache-2.0
// A tab as the worker sees it. A browser may put a tab to sleep, and what is sent to it then waits in memory: so a tab
// is sent no new state before it has taken the one before, and wakes up to a new one instead of to hours of old ones.
import type { Connection } from "./connection";
import type { TabMessage, WorkerMessage } from "./shared_stream";
import type { StreamEvent, StreamListener } from "./transport";

/** The part of a MessagePort that is used. */
export interface TabPort {
  onmessage: ((event: MessageEvent<TabMessage>) => void) | null;
  postMessage(message: WorkerMessage): void;
}

export class WorkerTab implements StreamListener {
  private readonly port: TabPort;
  private isReady = true;

  constructor(port: TabPort, connection: Connection) {
    this.port = port;
    port.onmessage = (event) => {
      this.isReady = true;
      if (event.data === "leave") {
        connection.leave(this);
      }
    };
    port.postMessage({ type: "joined" });
    connection.join(this);
  }

  hear(type: StreamEvent, data: string): void {
    if (type === "state") {
      if (!this.isReady) {
        return;
      }
      this.isReady = false;
    }
    this.port.postMessage({ type, data });
  }

  lose(reason: string | null): void {
    this.port.postMessage({ type: "lost", reason });
  }
}
