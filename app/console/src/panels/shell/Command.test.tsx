// SPDX-License-Identifier: Apache-2.0
// Rule under test: a page takes, asks for and gives up authority by its own number, renews it by itself, and has none when
// no user sees it.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Authority, Role } from "@interface";
import { RENEW_MS } from "../../state/authority";
import { Operation } from "../../state/operation";
import { makeAuthority, makeSession } from "../../testing/robot";
import { Command } from "./Command";

const anothers = makeAuthority({
  state: "held",
  source: "IGTL",
  peer: 11,
  name: "brp 127.0.0.1:53212",
});
let page: number;
let refusals: Record<string, number>;
let operation: Operation;
let shown: ReturnType<typeof render>;

function answer(path: string, method: string): Response {
  if (path === "/api/v1/session") {
    return new Response(JSON.stringify(makeSession(role)));
  }
  const status = refusals[method] ?? 200;
  return new Response(JSON.stringify({ detail: "It is refused." }), { status });
}

const fetched = vi.fn((path: string, options: RequestInit) =>
  Promise.resolve(answer(path, options.method ?? "")),
);
let role: Role;

/** The requests of the page, in short. */
function acts(): string[] {
  return fetched.mock.calls
    .filter(([path]) => path !== "/api/v1/session")
    .map(([path, { method, body }]) =>
      `${method} ${path.replace("/api/v1/", "")} ${typeof body === "string" ? body : ""}`.trim(),
    );
}

function headersOf(index: number): Record<string, string> {
  const [, options] = fetched.mock.calls.filter(
    ([path]) => path !== "/api/v1/session",
  )[index] ?? ["", {}];
  return options.headers as Record<string, string>;
}

async function show(authority: Authority): Promise<void> {
  await act(async () => {
    operation.session.start();
    await vi.advanceTimersByTimeAsync(0);
  });
  shown = render(<Command operation={operation} authority={authority} />);
}

async function press(name: string): Promise<void> {
  fireEvent.click(screen.getByRole("button", { name }));
  await act(() => vi.advanceTimersByTimeAsync(0));
}

async function pass(ms: number): Promise<void> {
  await act(() => vi.advanceTimersByTimeAsync(ms));
}

function mine(): Authority {
  return makeAuthority({
    state: "held",
    source: "HTTP",
    peer: page,
    name: "page of anna",
  });
}

function hide(state: DocumentVisibilityState): void {
  Object.defineProperty(document, "visibilityState", {
    value: state,
    configurable: true,
  });
  document.dispatchEvent(new Event("visibilitychange"));
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("fetch", fetched);
  vi.spyOn(crypto, "getRandomValues").mockImplementation((array) => {
    (array as Uint32Array)[0] = page;
    return array;
  });
  page = 4_000_000_000;
  role = "OPERATOR";
  refusals = {};
  operation = new Operation();
});

afterEach(() => {
  cleanup();
  operation.session.stop();
  hide("visible");
  vi.useRealTimers();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
  fetched.mockClear();
});

test("SWR-CON-014 a page takes what is free, by its number and token", async () => {
  await show(makeAuthority());
  await press("Take command");
  expect(acts()).toEqual(['POST authority {"id":1}']);
  expect(headersOf(0)).toMatchObject({
    "X-Boresight-Page": "4000000000",
    "X-Boresight-Token": "t0ken",
  });
  shown.rerender(<Command operation={operation} authority={mine()} />);
  expect(screen.getByText("This page commands.")).toBeTruthy();
});

test("SWR-CON-014 a page never has the number 0", async () => {
  page = 0;
  operation = new Operation();
  await show(makeAuthority());
  await press("Take command");
  expect(headersOf(0)["X-Boresight-Page"]).toBe("1");
});

test("SWR-CON-014 what a page has it renews by itself until it gives it up", async () => {
  await show(makeAuthority());
  await pass(RENEW_MS);
  expect(acts()).toEqual([]);
  await press("Take command");
  shown.rerender(<Command operation={operation} authority={mine()} />);
  await pass(2 * RENEW_MS);
  expect(acts().slice(1)).toEqual(["PUT authority", "PUT authority"]);
  await press("Give up command");
  await pass(2 * RENEW_MS);
  expect(acts().slice(3)).toEqual(["DELETE authority"]);
});

test("SWR-BOX-045 in fast time it renews as many times as often", async () => {
  await show(makeAuthority());
  shown.rerender(
    <Command operation={operation} authority={makeAuthority()} speedup={10} />,
  );
  await press("Take command");
  await pass(RENEW_MS);
  expect(acts().length).toBe(11);
});

test("SWR-CON-014 renewals end after two in a row were refused", async () => {
  await show(makeAuthority());
  await press("Take command");
  refusals = { PUT: 423 };
  await pass(4 * RENEW_MS);
  expect(acts().slice(1)).toEqual(["PUT authority", "PUT authority"]);
});

/** The server has refused to renew, and the stream still says that this page commands. */
async function endRenewals(): Promise<void> {
  await show(makeAuthority());
  await press("Take command");
  shown.rerender(<Command operation={operation} authority={mine()} />);
  refusals = { PUT: 423 };
  await pass(4 * RENEW_MS);
  fetched.mockClear();
}

test("SWR-CON-320 command is given up after renewing has ended, as long as the stream names this page", async () => {
  await endRenewals();
  await press("Give up command");
  expect(acts()).toEqual(["DELETE authority"]);
  expect(operation.authority.left).toBe("by hand");
});

test("SWR-CON-320 a hidden page gives up after renewing has ended, as long as the stream names this page", async () => {
  await endRenewals();
  hide("hidden");
  expect(acts()).toEqual(["DELETE authority"]);
});

test("SWR-CON-320 command is given up that the stream shows and no answer has confirmed", async () => {
  await show(makeAuthority());
  shown.rerender(<Command operation={operation} authority={mine()} />);
  await press("Give up command");
  expect(acts()).toEqual(["DELETE authority"]);
});

test("SWR-CON-320 a request that the stream shows and no answer has confirmed is withdrawn", async () => {
  await show({ ...anothers, requester: "HTTP", requester_peer: page });
  await press("Ask no more");
  expect(acts()).toEqual(["DELETE authority"]);
});

test("SWR-CON-320 a page gives nothing up once the stream names another", async () => {
  await endRenewals();
  shown.rerender(<Command operation={operation} authority={anothers} />);
  hide("hidden");
  expect(acts()).toEqual([]);
});

test("SWR-CON-014 a server that is busy ends no renewals", async () => {
  await show(makeAuthority());
  await press("Take command");
  refusals = { PUT: 503 };
  await pass(4 * RENEW_MS);
  expect(acts().slice(1)).toHaveLength(4);
});

test("SWR-CON-014 a renewal that was refused once, now and then, is tried again", async () => {
  await show(makeAuthority());
  await press("Take command");
  for (let round = 0; round < 3; round += 1) {
    refusals = { PUT: 423 };
    await pass(RENEW_MS);
    refusals = {};
    await pass(RENEW_MS);
  }
  expect(acts().slice(1)).toHaveLength(6);
});

test("SWR-CON-014 a renewal without an answer is tried again", async () => {
  await show(makeAuthority());
  await press("Take command");
  fetched.mockRejectedValueOnce(new TypeError("no answer"));
  await pass(2 * RENEW_MS);
  expect(acts().slice(1)).toEqual(["PUT authority", "PUT authority"]);
});

test("SWR-CON-014 a refusal is reported, and renews nothing", async () => {
  refusals = { POST: 423 };
  await show(makeAuthority());
  await press("Take command");
  expect(screen.getByRole("alert").textContent).toBe("It is refused.");
  await pass(RENEW_MS);
  expect(acts().length).toBe(1);
});

test("SWR-CON-014 what another has is asked for, and renewed once the button was pressed", async () => {
  await show(anothers);
  await press("Ask for command");
  expect(acts()).toEqual(['POST authority/request {"id":1,"what":"TAKE"}']);
  const asked = {
    ...anothers,
    requester: "HTTP",
    requester_peer: page,
  } as const;
  shown.rerender(<Command operation={operation} authority={asked} />);
  expect(screen.getByText(/press the button at the box/)).toBeTruthy();
  await pass(RENEW_MS);
  shown.rerender(<Command operation={operation} authority={mine()} />);
  await pass(RENEW_MS);
  expect(acts().slice(1)).toEqual(["PUT authority"]);
});

test("SWR-CON-014 what was asked for is withdrawn", async () => {
  await show(anothers);
  await press("Ask for command");
  const asked = {
    ...anothers,
    requester: "HTTP",
    requester_peer: page,
  } as const;
  shown.rerender(<Command operation={operation} authority={asked} />);
  await press("Ask no more");
  expect(acts().slice(1)).toEqual(["DELETE authority"]);
});

test("SWR-CON-014 while the axes come to rest nothing can be asked for", async () => {
  await show(makeAuthority({ state: "ending" }));
  expect(screen.queryByRole("button")).toBeNull();
});

test("SWR-CON-014 who may only observe is offered nothing", async () => {
  role = "OBSERVER";
  await show(makeAuthority());
  expect(screen.queryByRole("button")).toBeNull();
});

test("SWR-CON-015 a page that is hidden gives up what it has, once", async () => {
  await show(makeAuthority());
  await press("Take command");
  shown.rerender(<Command operation={operation} authority={mine()} />);
  hide("hidden");
  shown.rerender(<Command operation={operation} authority={{ ...mine() }} />);
  await pass(2 * RENEW_MS);
  expect(acts().slice(1)).toEqual(["DELETE authority"]);
  const options = fetched.mock.calls.at(-1)?.[1];
  expect(options?.keepalive).toBe(true);
});

test("SWR-CON-015 a page that is hidden before it gets an answer gives up what it gets", async () => {
  await show(makeAuthority());
  fireEvent.click(screen.getByRole("button", { name: "Take command" }));
  hide("hidden");
  await pass(2 * RENEW_MS);
  expect(acts().slice(1)).toEqual(["DELETE authority"]);
});

test("SWR-CON-015 a page that is hidden before it gets an answer asks no more", async () => {
  await show(anothers);
  fireEvent.click(screen.getByRole("button", { name: "Ask for command" }));
  hide("hidden");
  await pass(0);
  expect(acts().slice(1)).toEqual(["DELETE authority"]);
});

test("SWR-CON-015 a page that is closed withdraws what it asked for", async () => {
  await show(anothers);
  await press("Ask for command");
  window.dispatchEvent(new Event("pagehide"));
  expect(acts().slice(1)).toEqual(["DELETE authority"]);
});

test("SWR-CON-015 a page that has nothing gives nothing up", async () => {
  await show(anothers);
  hide("hidden");
  hide("visible");
  window.dispatchEvent(new Event("pagehide"));
  expect(acts()).toEqual([]);
});
