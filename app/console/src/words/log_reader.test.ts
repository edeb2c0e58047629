// SPDX-License-Identifier: Apache-2.0
// Rule under test: the log is read as the server searches it, each event once, and follows the events of the stream.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Log, LogEntry } from "@interface";
import { LogReader, MOST_ENTRIES } from "./log_reader";
import { Page } from "../state/page";
import { makeEntry } from "../testing/robot";

const asked: string[] = [];
let answer: (query: URLSearchParams) => Log | null;
let reader: LogReader;

/** A server that has had so many events, and looks at no more than `limit`. */
function makeServer(count: () => number) {
  return (query: URLSearchParams): Log => {
    const after = query.get("after");
    const limit = Number(query.get("limit"));
    const all = Array.from({ length: count() }, (_, number) =>
      makeEntry(number),
    );
    const entries =
      after === null
        ? all.slice(-limit)
        : all.slice(Number(after) + 1, Number(after) + 1 + limit);
    return {
      entries,
      next: (entries.at(-1)?.number ?? Number(after)) + 1,
      lost: 0,
    };
  };
}

function numbers(): number[] {
  return reader.getReading().entries.map(({ number }) => number);
}

async function settle(): Promise<void> {
  for (let turn = 0; turn < 20; turn += 1) {
    await new Promise((resolve) => setTimeout(resolve, 0));
  }
}

beforeEach(() => {
  asked.length = 0;
  vi.stubGlobal("fetch", (address: string) => {
    if (address.startsWith("/api/v1/log")) asked.push(address); // a page of another test may still ask for its session
    const log = answer(new URL(address, "http://x").searchParams);
    return Promise.resolve(
      new Response(JSON.stringify(log ?? {}), { status: log ? 200 : 503 }),
    );
  });
  reader = new LogReader(new Page(() => null));
});

afterEach(() => vi.unstubAllGlobals());

test("SWR-CON-038 the newest events come first", async () => {
  answer = makeServer(() => 3);
  reader.search({ level: "WARNING", text: "card 3" });
  await settle();
  expect(asked).toEqual(["/api/v1/log?limit=200&level=WARNING&text=card+3"]);
  expect(numbers()).toEqual([2, 1, 0]);
  expect(reader.getReading().isComplete).toBe(true);
});

test("SWR-CON-038 what the stream announces is asked for once, after the last one", async () => {
  let count = 3;
  answer = makeServer(() => count);
  reader.search({ level: "INFORMATION", text: "" });
  await settle();
  count = 5;
  reader.follow(3);
  reader.follow(4);
  await settle();
  expect(numbers()).toEqual([4, 3, 2, 1, 0]);
  expect(asked.slice(1)).toEqual([
    "/api/v1/log?limit=200&level=INFORMATION&after=2",
  ]);
});

test("SWR-CON-038 more than one answer holds are asked for until all are there", async () => {
  let count = 1;
  answer = makeServer(() => count);
  reader.search({ level: "INFORMATION", text: "" });
  await settle();
  count = 450;
  reader.follow(449);
  await settle();
  expect(numbers()).toHaveLength(450);
  expect(asked).toHaveLength(4);
});

test("SWR-CON-038 a server that knows of no more is not asked for ever", async () => {
  answer = makeServer(() => 3);
  reader.search({ level: "INFORMATION", text: "" });
  reader.follow(9);
  await settle();
  expect(asked.length).toBeLessThan(4);
});

test("SWR-CON-038 control that has started again begins the list anew", async () => {
  let count = 5;
  answer = makeServer(() => count);
  reader.follow(4);
  await settle();
  expect(numbers()).toHaveLength(5);
  count = 2;
  reader.follow(1);
  await settle();
  expect(numbers()).toEqual([1, 0]);
});

test("SWR-CON-038 another search begins the list anew, whatever is still on its way", async () => {
  answer = makeServer(() => 3);
  reader.search({ level: "INFORMATION", text: "" });
  answer = () => ({ entries: [makeEntry(7)], next: 8, lost: 0 });
  reader.search({ level: "CRITICAL", text: "" });
  await settle();
  expect(numbers()).toEqual([7]);
});

test("SWR-CON-038 older ones are those until the oldest, each once", async () => {
  const all = Array.from({ length: 300 }, (_, number) => makeEntry(number));
  const page = (entries: LogEntry[]): Log => ({ entries, next: 300, lost: 0 });
  answer = (query) =>
    query.has("to") ? page(all.slice(0, 150)) : page(all.slice(100));
  reader.search({ level: "INFORMATION", text: "" });
  await settle();
  expect(reader.getReading().isComplete).toBe(false);
  await reader.readOlder();
  expect(asked.at(-1)).toContain("&to=2026-11-22T17:50:00.123999Z");
  expect(numbers()).toEqual(all.map(({ number }) => number).reverse());
  expect(reader.getReading().isComplete).toBe(true);
});

test("SWR-CON-038 no answer is reported, and the list stays", async () => {
  answer = makeServer(() => 3);
  reader.follow(2);
  await settle();
  answer = () => null;
  reader.follow(3);
  await settle();
  expect(reader.getReading().hasFailed).toBe(true);
  expect(numbers()).toEqual([2, 1, 0]);
});

test("SWR-CON-038 the page keeps so many events and no more", async () => {
  let count = 1;
  answer = makeServer(() => count);
  reader.follow(0);
  await settle();
  count = MOST_ENTRIES + 100;
  reader.follow(count - 1);
  await settle();
  await settle();
  expect(numbers()).toHaveLength(MOST_ENTRIES);
  expect(reader.getReading().isComplete).toBe(false);
});
