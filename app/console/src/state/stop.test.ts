// SPDX-License-Identifier: Apache-2.0
// Rule under test: a stop tries every way, says truly what came of it, and never leaves after it was given up.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { HEDGE_MS, isSeenStopped, requestStop, STOP_TIMEOUT_MS } from "./stop";
import { makeAxis, makeRobot } from "../testing/robot";

const OWN = "http://127.0.0.1:40000/api/v1/stop";
const CONSOLE = "/api/v1/stop";
const stopped = {
  workphase: { name: "STOP", text: "Stopped by command." },
} as const;

type Answer = "accepted" | "refused" | "unreachable" | "silent";
let asked: string[];
let answers: Record<string, Answer>;
let signals: AbortSignal[];

function answer(address: string, signal: AbortSignal): Promise<Response> {
  switch (answers[address]) {
    case "accepted":
      return Promise.resolve(new Response("{}"));
    case "refused":
      return Promise.resolve(
        new Response('{"detail":"Control does not answer."}', { status: 503 }),
      );
    case "silent":
      return new Promise((_, reject) => {
        signal.addEventListener("abort", () => reject(new Error("aborted")));
      });
    default:
      return Promise.reject(new TypeError("unreachable"));
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  asked = [];
  signals = [];
  answers = {};
  vi.stubGlobal(
    "fetch",
    (address: string, { signal }: { signal: AbortSignal }) => {
      asked.push(address);
      signals.push(signal);
      return answer(address, signal);
    },
  );
});

afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

async function stop(addresses = [OWN, CONSOLE]) {
  const result = requestStop(addresses);
  await vi.advanceTimersByTimeAsync(STOP_TIMEOUT_MS);
  return result;
}

test("SWR-CON-007 a stop that was accepted at its own port asks nowhere else", async () => {
  answers = { [OWN]: "accepted" };
  expect((await stop()).isConfirmed).toBe(true);
  expect(asked).toEqual([OWN]);
});

test("SWR-CON-007 the port of the console is asked at once when the other cannot be reached", async () => {
  answers = { [CONSOLE]: "accepted" };
  const result = requestStop([OWN, CONSOLE]);
  await vi.advanceTimersByTimeAsync(0);
  expect((await result).isConfirmed).toBe(true);
  expect(asked).toEqual([OWN, CONSOLE]);
});

test("SWR-CON-007 the port of the console is asked as well when the other is silent", async () => {
  answers = { [OWN]: "silent", [CONSOLE]: "accepted" };
  const result = requestStop([OWN, CONSOLE]);
  await vi.advanceTimersByTimeAsync(HEDGE_MS - 1);
  expect(asked).toEqual([OWN]);
  await vi.advanceTimersByTimeAsync(1);
  expect((await result).isConfirmed).toBe(true);
});

test("SWR-CON-007 what was given up does not leave later", async () => {
  answers = { [OWN]: "silent", [CONSOLE]: "silent" };
  expect(await stop()).toEqual({
    isConfirmed: false,
    reason: "The server does not answer.",
  });
  expect(signals.every((signal) => signal.aborted)).toBe(true);
});

test("SWR-CON-007 what the server says of the failure is reported", async () => {
  answers = { [OWN]: "unreachable", [CONSOLE]: "refused" };
  expect((await stop()).reason).toBe("Control does not answer.");
});

test("SWR-CON-008 stopped is what live data shows and nothing else", () => {
  const robot = makeRobot(stopped);
  expect(isSeenStopped("live", robot)).toBe(true);
  expect(isSeenStopped("late", robot)).toBeNull();
  expect(isSeenStopped("stale", robot)).toBeNull();
  expect(isSeenStopped("live", null)).toBeNull();
  const { status, targeting } = robot;
  const unreadable = { status, targeting } as typeof robot;
  expect(isSeenStopped("live", unreadable)).toBeNull();
  expect(isSeenStopped("live", makeRobot())).toBe(false);
  const driven = makeAxis("head", { is_driven: true });
  expect(isSeenStopped("live", makeRobot(stopped, [driven]))).toBe(false);
});
