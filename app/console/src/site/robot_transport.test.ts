// SPDX-License-Identifier: Apache-2.0
// Rule under test: the robot in a worker is asked and listened to as the one behind a server.
import { beforeEach, expect, test, vi } from "vitest";
import type { Order, Report } from "./messages";
import { RobotTransport, type RobotPort } from "./robot_transport";

const start: Order & { kind: "start" } = {
  kind: "start",
  packed: "",
  robot: "neuro",
  seed: 1,
  scene: null,
  utcS: 0,
};
const listener = { hear: vi.fn(), lose: vi.fn() };
let orders: Order[];
let port: RobotPort;
let transport: RobotTransport;

function report(data: Report): void {
  port.onmessage?.(new MessageEvent("message", { data }));
}

function answer(status: number, body: string): void {
  const asks = orders.filter((order) => order.kind === "ask");
  const id = asks.at(-1)?.id ?? 0;
  const headers: [string, string][] = [["Retry-After", "3"]];
  const answered = { status, reason: "Said", headers, body };
  report({ kind: "answer", id, answered });
}

beforeEach(() => {
  vi.clearAllMocks();
  orders = [];
  port = {
    onmessage: null,
    onerror: null,
    postMessage: (order) => orders.push(order),
  };
  transport = new RobotTransport(port, start);
});

test("SWR-SITE-011 a request is answered as fetch() answers it", async () => {
  const options = { method: "POST", headers: { "X-A": "b" }, body: "{}" };
  const response = transport.request("/api/v1/stop", options);
  expect(orders).toEqual([
    start,
    {
      kind: "ask",
      id: 1,
      asked: {
        method: "POST",
        address: "/api/v1/stop",
        headers: { "x-a": "b" },
        body: "{}",
      },
    },
  ]);
  answer(409, '{"detail":"No."}');
  const { status, statusText, headers } = await response;
  expect([status, statusText, headers.get("Retry-After")]).toEqual([
    409,
    "Said",
    "3",
  ]);
  expect(await (await response).json()).toEqual({ detail: "No." });
  expect(transport.stopAddresses()).toEqual(["/api/v1/stop"]);
});

test("SWR-SITE-011 a request that is given up rejects, and one after a failure", async () => {
  const abort = new AbortController();
  const { signal } = abort;
  const given = transport.request("/api/v1/stop", { signal });
  abort.abort();
  await expect(given).rejects.toThrow();
  const waiting = transport.request("/api/v1/stop", {});
  report({ kind: "failed", reason: "It is gone." });
  await expect(waiting).rejects.toThrow("It is gone.");
  await expect(transport.request("/api/v1/stop", {})).rejects.toThrow(
    "It is gone.",
  );
  expect(transport.getView().failure).toBe("It is gone.");
});

test("SWR-SITE-011 the stream is asked for, heard, and closed", () => {
  const stream = transport.openStream(listener);
  expect(orders.at(-1)).toMatchObject({
    asked: { method: "GET", address: "/api/v1/events" },
  });
  report({ kind: "reported", type: "state", data: "s" });
  expect(listener.hear).toHaveBeenCalledExactlyOnceWith("state", "s");
  stream.close();
  report({ kind: "reported", type: "state", data: "t" });
  expect(listener.hear).toHaveBeenCalledOnce();
});

test("SWR-SITE-011 a stream that is refused or whose robot fails is lost, with the reason", async () => {
  transport.openStream(listener);
  answer(503, '{"detail":"Later."}');
  await vi.waitFor(() => expect(listener.lose).toHaveBeenCalledWith("Later."));
  transport.openStream(listener);
  port.onerror?.(new ErrorEvent("error", { message: "It is gone." }));
  await vi.waitFor(() =>
    expect(listener.lose).toHaveBeenLastCalledWith("It is gone."),
  );
});

test("SWR-SITE-014 pace and cycle are ordered from the worker, whose time is known", () => {
  const changed = vi.fn();
  transport.subscribe(changed);
  transport.setPace(0);
  transport.step();
  report({ kind: "time", cycles: 12, end: 12, later: 0 });
  expect(orders.slice(1)).toEqual([
    { kind: "pace", share: 0 },
    { kind: "step" },
  ]);
  expect(transport.getView()).toMatchObject({ share: 0, cycles: 12 });
  expect(changed).toHaveBeenCalledTimes(2);
});

test("SWR-SITE-026 what asks for the robot of a link that is refused gets the reason", async () => {
  report({ kind: "refused", reason: "At character 1: no." });
  expect(transport.getView()).toMatchObject({
    failure: "At character 1: no.",
    isRefused: true,
  });
  await expect(transport.request("/api/v1/robot", {})).rejects.toThrow(
    "At character 1: no.",
  );
});

test("SWR-SITE-031 time stands still where it goes to, and the stream goes on from the server there", () => {
  transport.openStream(listener);
  transport.goTo(5);
  expect(orders.at(-1)).toEqual({ kind: "go", cycle: 5 });
  report({ kind: "restarted" });
  expect(orders.at(-1)).toMatchObject({
    asked: { method: "GET", address: "/api/v1/events" },
  });
  expect(listener.lose).not.toHaveBeenCalled();
  report({ kind: "time", cycles: 5, end: 12, later: 3 });
  expect(transport.getView()).toMatchObject({
    share: 0,
    cycles: 5,
    end: 12,
    later: 3,
  });
});

test("SWR-SITE-033 a question is put to the worker, and its answer known", () => {
  const question = { input: "estop pull", seconds: 4 };
  transport.compare(question);
  expect(orders.at(-1)).toEqual({ kind: "compare", question });
  const answer = { question, cycle: 1, lines: [], problem: "No.", scene: null };
  report({ kind: "compared", ...answer });
  expect(transport.getView().compared).toMatchObject(answer);
});

test("SWR-SITE-030 what was done is asked for, and known then", () => {
  transport.shareCourse();
  expect(orders.at(-1)).toEqual({ kind: "share" });
  const shared: Report = { kind: "unshared", reason: "No." };
  report(shared);
  expect(transport.getView().shared).toEqual(shared);
});
