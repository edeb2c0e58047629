// SPDX-License-Identifier: Apache-2.0
// The shared worker: one connection to the server for all tabs of a browser.
import { Connection, type StreamListener } from "./connection";
import type { WorkerMessage } from "./shared_stream";

const connection = new Connection();

function welcome(port: MessagePort): void {
  const tell = (message: WorkerMessage) => port.postMessage(message);
  const tab: StreamListener = {
    hear: (type, data) => tell({ type, data }),
    lose: (reason) => tell({ type: "lost", reason }),
  };
  port.onmessage = () => connection.leave(tab);
  tell({ type: "joined" });
  connection.join(tab);
}

self.addEventListener("connect", (event) => {
  const [port] = (event as MessageEvent).ports;
  if (port !== undefined) {
    welcome(port);
  }
});
