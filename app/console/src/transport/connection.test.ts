// SPDX-License-Identifier: Apache-2.0
// Rule under test: however many tabs there are, the server sees one stream, and each tab hears all that matters.
import { beforeEach, expect, test } from "vitest";
import { Connection, type Source } from "./connection";
import { LOG_LENGTH, type StreamListener } from "./transport";

class FakeSource implements Source {
  onerror: ((event: Event) => void) | null = null;
  isClosed = false;
  private readonly listeners = new Map<
    string,
    (event: MessageEvent<string>) => void
  >();

  addEventListener(
    type: string,
    listener: (event: MessageEvent<string>) => void,
  ): void {
    this.listeners.set(type, listener);
  }

  close(): void {
    this.isClosed = true;
  }

  send(type: string, data: string): void {
    this.listeners.get(type)?.(new MessageEvent(type, { data }));
  }
}

class Tab implements StreamListener {
  readonly heard: string[] = [];
  readonly lost: (string | null)[] = [];

  hear(type: string, data: string): void {
    this.heard.push(`${type} ${data}`);
  }

  lose(reason: string | null): void {
    this.lost.push(reason);
  }
}

let sources: FakeSource[];
let reasons: number;
let connection: Connection;

function newest(): FakeSource {
  const source = sources.at(-1);
  if (source === undefined) {
    throw new Error("nothing was opened");
  }
  return source;
}

async function fail(): Promise<void> {
  newest().onerror?.(new Event("error"));
  await new Promise((resolve) => setTimeout(resolve));
}

beforeEach(() => {
  sources = [];
  reasons = 0;
  connection = new Connection({
    openSource: () => {
      sources.push(new FakeSource());
      return newest();
    },
    askReason: () => {
      reasons += 1;
      return Promise.resolve("Too many consoles are open.");
    },
  });
});

test("SWR-CON-006 nine tabs share one stream and hear the same", () => {
  const tabs = Array.from({ length: 9 }, () => new Tab());
  tabs.forEach((tab) => connection.join(tab));
  newest().send("state", "1");
  expect(sources).toHaveLength(1);
  tabs.forEach((tab) => expect(tab.heard).toEqual(["state 1"]));
});

test("SWR-CON-006 who comes later gets the greeting and the log, but no old state", () => {
  connection.join(new Tab());
  newest().send("hello", "h");
  newest().send("state", "1");
  for (let number = 0; number <= LOG_LENGTH; number++) {
    newest().send("log", String(number));
  }
  const late = new Tab();
  connection.join(late);
  expect(late.heard[0]).toBe("hello h");
  expect(late.heard[1]).toBe("log 1");
  expect(late.heard).toHaveLength(LOG_LENGTH + 1);
});

test("SWR-CON-006 the stream ends with the last tab and begins again with the next", () => {
  const tabs = [new Tab(), new Tab()];
  tabs.forEach((tab) => connection.join(tab));
  tabs.forEach((tab, index) => {
    expect(newest().isClosed).toBe(false);
    connection.leave(tab);
    expect(newest().isClosed).toBe(index === 1);
  });
  connection.leave(new Tab());
  connection.join(new Tab());
  expect(sources).toHaveLength(2);
});

test("SWR-CON-006 every tab is informed that the stream is lost, and the next one opens it again", async () => {
  const tabs = [new Tab(), new Tab()];
  tabs.forEach((tab) => connection.join(tab));
  newest().send("hello", "h");
  await fail();
  expect(tabs.map((tab) => tab.lost)).toEqual([[null], [null]]);
  tabs.forEach((tab) => connection.join(tab));
  expect(sources).toHaveLength(2);
  expect(reasons).toBe(0);
});

test("SWR-CON-011 the server is asked why it refused the stream", async () => {
  const tab = new Tab();
  connection.join(tab);
  await fail();
  expect(tab.lost).toEqual(["Too many consoles are open."]);
});
