// SPDX-License-Identifier: Apache-2.0
// Rule under test: a tab gets the stream by the worker, and by itself when the worker cannot be had.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Connection } from "./connection";
import {
  GREETING_MS,
  SharedStream,
  type Port,
  type WorkerMessage,
} from "./shared_stream";
import type { StreamListener } from "./transport";

const listener: StreamListener = { hear: vi.fn(), lose: vi.fn() };
const openAlone = vi.fn();
let port: Port;
let fail: () => void;

function send(message: WorkerMessage): void {
  port.onmessage?.(new MessageEvent("message", { data: message }));
}

function open(): SharedStream {
  return new SharedStream(
    listener,
    (onFailure) => {
      fail = onFailure;
      return port;
    },
    openAlone,
  );
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.clearAllMocks();
  port = { onmessage: null, postMessage: vi.fn(), close: vi.fn() };
  openAlone.mockImplementation(
    () =>
      new Connection({
        openSource: () => ({
          addEventListener: () => undefined,
          onerror: null,
          close: () => undefined,
        }),
        askReason: () => Promise.resolve(null),
      }),
  );
});

afterEach(() => vi.useRealTimers());

test("SWR-CON-006 what the worker hears reaches the tab", () => {
  open();
  send({ type: "joined" });
  send({ type: "hello", data: "h" });
  send({ type: "lost", reason: "Too many." });
  expect(listener.hear).toHaveBeenCalledExactlyOnceWith("hello", "h");
  expect(port.postMessage).toHaveBeenCalledExactlyOnceWith("ready");
  expect(listener.lose).toHaveBeenCalledExactlyOnceWith("Too many.");
  vi.advanceTimersByTime(GREETING_MS);
  expect(openAlone).not.toHaveBeenCalled();
});

test("SWR-CON-006 a tab that closes leaves the worker", () => {
  const stream = open();
  stream.close();
  expect(port.postMessage).toHaveBeenCalledExactlyOnceWith("leave");
  vi.advanceTimersByTime(GREETING_MS);
  expect(openAlone).not.toHaveBeenCalled();
});

test("SWR-CON-006 a browser that refuses or lacks shared workers is served all the same", () => {
  new SharedStream(
    listener,
    () => {
      throw new DOMException("refused", "SecurityError");
    },
    openAlone,
  );
  expect(openAlone).toHaveBeenCalledOnce();
});

test("SWR-CON-006 a worker that fails or does not greet is done without", () => {
  open();
  fail();
  fail();
  expect(openAlone).toHaveBeenCalledOnce();
  open();
  vi.advanceTimersByTime(GREETING_MS);
  expect(openAlone).toHaveBeenCalledTimes(2);
});

test("SWR-CON-006 a worker that greets late takes the tab back from its own connection", () => {
  const leave = vi.spyOn(Connection.prototype, "leave");
  const stream = open();
  vi.advanceTimersByTime(GREETING_MS);
  expect(openAlone).toHaveBeenCalledOnce();
  send({ type: "joined" });
  expect(leave).toHaveBeenCalledExactlyOnceWith(listener);
  send({ type: "hello", data: "h" });
  expect(listener.hear).toHaveBeenCalledExactlyOnceWith("hello", "h");
  stream.close();
  expect(leave).toHaveBeenCalledOnce();
});
