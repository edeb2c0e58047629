// SPDX-License-Identifier: Apache-2.0
// The shared worker: one connection to the server for all tabs of a browser.
import { Connection } from "./connection";
import { WorkerTab } from "./worker_tab";

const connection = new Connection();

self.addEventListener("connect", (event) => {
  const [port] = (event as MessageEvent).ports;
  if (port !== undefined) {
    new WorkerTab(port, connection);
  }
});
