// SPDX-License-Identifier: Apache-2.0
// Rule under test: data that stops coming is noticed within a second, for each cause.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { LOG_LENGTH } from "../transport/transport";
import { TelemetryStore } from "./store";
import { makeEntry, makeRobot } from "../testing/robot";
import { FakeSurroundings } from "../testing/surroundings";

let surroundings: FakeSurroundings;
let store: TelemetryStore;

function pass(ms: number): void {
  surroundings.pass(ms);
  vi.advanceTimersByTime(100);
}

beforeEach(() => {
  vi.useFakeTimers();
  surroundings = new FakeSurroundings();
  store = new TelemetryStore(surroundings);
  store.start();
});

afterEach(() => {
  store.stop();
  vi.useRealTimers();
});

test("SWR-CON-004 data is live as long as it comes", () => {
  surroundings.stream.send("state", makeRobot());
  pass(100);
  surroundings.stream.send("state", makeRobot());
  pass(100);
  expect(store.getView().freshness).toBe("live");
});

test("SWR-CON-004 data is late after 300 ms of silence", () => {
  surroundings.stream.send("state", makeRobot());
  pass(301);
  expect(store.getView().freshness).toBe("late");
});

test("SWR-CON-004 data is stale within a second of silence", () => {
  surroundings.stream.send("state", makeRobot());
  pass(900);
  expect(store.getView().freshness).toBe("stale");
});

test("SWR-CON-004 a frozen control is stale though messages keep coming", () => {
  surroundings.stream.send("state", makeRobot({ age_ms: 900 }));
  expect(store.getView().freshness).toBe("stale");
});

test("SWR-CON-004 data is stale at once when the connection is lost", () => {
  surroundings.stream.send("state", makeRobot());
  surroundings.stream.fail();
  expect(store.getView().freshness).toBe("stale");
  pass(100);
  expect(store.getView().freshness).toBe("stale");
});

test("SWR-CON-004 a lost connection is opened again and data is live again", () => {
  surroundings.stream.fail();
  pass(600);
  expect(surroundings.streams).toHaveLength(2);
  surroundings.stream.send("state", makeRobot());
  expect(store.getView().freshness).toBe("live");
});

test("SWR-CON-001 a server of another build is noticed", () => {
  surroundings.stream.send("hello", { boot_id: "1", build_id: "a" });
  expect(store.getView().isOutdated).toBe(false);
  surroundings.stream.send("hello", { boot_id: "2", build_id: "b" });
  expect(store.getView().isOutdated).toBe(true);
});

test("SWR-CON-001 the last events are kept, newest first", () => {
  for (let number = 0; number < LOG_LENGTH + 5; number++) {
    surroundings.stream.send("log", makeEntry(number));
  }
  const { log } = store.getView();
  expect(log).toHaveLength(LOG_LENGTH);
  expect(log[0]?.number).toBe(LOG_LENGTH + 4);
});

test("SWR-CON-004 old data is not taken for new when the stream greets again", () => {
  surroundings.stream.send("state", makeRobot());
  surroundings.stream.fail();
  pass(2000);
  surroundings.stream.send("hello", { boot_id: "1", build_id: "a" });
  pass(100);
  expect(store.getView().freshness).toBe("stale");
});

test("SWR-CON-004 a stream that falls silent is opened again", () => {
  surroundings.stream.send("state", makeRobot());
  pass(3000);
  expect(surroundings.streams[0]?.isClosed).toBe(true);
  pass(600);
  expect(surroundings.streams).toHaveLength(2);
});

test("SWR-CON-011 the reason that the server gives is kept until it greets", () => {
  surroundings.stream.fail("Too many consoles are open.");
  expect(store.getView().refusal).toBe("Too many consoles are open.");
  pass(600);
  surroundings.stream.send("hello", { boot_id: "1", build_id: "a" });
  expect(store.getView().refusal).toBeNull();
});

test("SWR-CON-009 a message that cannot be read asks for another page and harms nothing", () => {
  const robot = makeRobot();
  surroundings.stream.send("state", robot);
  surroundings.stream.send("state", {} as typeof robot);
  expect(store.getView().isOutdated).toBe(true);
  expect(store.getView().robot).toEqual(robot);
});
