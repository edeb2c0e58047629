// SPDX-License-Identifier: Apache-2.0
// Rule under test: a tab that sleeps costs nothing and wakes up to what is new.
import { expect, test, vi } from "vitest";
import { Connection } from "./connection";
import type { TabMessage } from "./shared_stream";
import { WorkerTab, type TabPort } from "./worker_tab";

function open() {
  const connection = new Connection({
    openSource: () => ({
      addEventListener: () => undefined,
      onerror: null,
      close: () => undefined,
    }),
    askReason: () => Promise.resolve(null),
  });
  const port = { onmessage: null, postMessage: vi.fn() } as TabPort & {
    postMessage: ReturnType<typeof vi.fn>;
  };
  const tab = new WorkerTab(port, connection);
  const say = (data: TabMessage) =>
    port.onmessage?.(new MessageEvent("message", { data }));
  return { connection, port, tab, say };
}

test("SWR-CON-006 a tab is sent no state before it has taken the one before", () => {
  const { port, tab, say } = open();
  tab.hear("state", "1");
  tab.hear("state", "2");
  tab.hear("log", "a");
  say("ready");
  tab.hear("state", "3");
  expect(port.postMessage.mock.calls.flat()).toEqual([
    { type: "joined" },
    { type: "state", data: "1" },
    { type: "log", data: "a" },
    { type: "state", data: "3" },
  ]);
});

test("SWR-CON-006 a tab joins, hears of a loss, and leaves when it says so", () => {
  const { connection, port, tab, say } = open();
  const leave = vi.spyOn(connection, "leave");
  tab.lose("Too many.");
  expect(port.postMessage).toHaveBeenLastCalledWith({
    type: "lost",
    reason: "Too many.",
  });
  say("ready");
  expect(leave).not.toHaveBeenCalled();
  say("leave");
  expect(leave).toHaveBeenCalledExactlyOnceWith(tab);
});
