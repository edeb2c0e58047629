// SPDX-License-Identifier: Apache-2.0
// Rule under test: a page says why it has lost its command or its session until that was read, and nothing of what it gave up.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { LogEntry, Session, Status } from "@interface";
import { Operation } from "./operation";
import { Losses } from "../parts/Losses";
import {
  makeAuthority,
  makeEntry,
  makeSession,
  makeStatus,
} from "../testing/robot";

const open: Session = {
  ...makeSession("OPERATOR"),
  boot_id: makeStatus().boot_id,
};
const closed: Session = { ...open, is_open: false, name: null, token: null };
const fetched = vi.fn<() => Promise<Response>>();
let answer: Session;
let operation: Operation;
let shown: ReturnType<typeof render>;

function of(status: Partial<Status>, log: LogEntry[] = []) {
  return <Losses operation={operation} status={makeStatus(status)} log={log} />;
}

function mine(): Partial<Status> {
  const { number } = operation.page;
  return {
    authority: makeAuthority({ state: "held", source: "HTTP", peer: number }),
  };
}

/** As the log says that this page has lost it. */
function lost(value: number): LogEntry[] {
  const subject = String(operation.page.number);
  return [
    makeEntry(3),
    makeEntry(2, { name: "AUTHORITY_LOST", subject, value }),
    makeEntry(1, { name: "AUTHORITY_TAKEN", subject }),
  ];
}

async function see(status: Partial<Status>, log: LogEntry[] = []) {
  shown.rerender(of(status, log));
  await act(() => vi.advanceTimersByTimeAsync(0));
}

function said(): string | null {
  return screen.queryByRole("alert")?.querySelector("p")?.textContent ?? null;
}

function hide(state: DocumentVisibilityState): void {
  Object.defineProperty(document, "visibilityState", {
    value: state,
    configurable: true,
  });
  document.dispatchEvent(new Event("visibilitychange"));
}

/** Logged in, and with command. */
beforeEach(async () => {
  vi.useFakeTimers();
  fetched.mockImplementation(() =>
    Promise.resolve(new Response(JSON.stringify(answer))),
  );
  vi.stubGlobal("fetch", fetched);
  answer = open;
  operation = new Operation();
  operation.authority.start();
  await operation.session.ask();
  await operation.authority.take();
  shown = render(of({}));
  await see(mine());
});

afterEach(() => {
  cleanup();
  operation.authority.stop();
  hide("visible");
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test.each([
  [0, "Command lost: the server gave it up."],
  [1, "Command lost: the server did not hear this page in time."],
  [2, "Command lost: the server gave no sign of life."],
  [3, "Command lost: another took it by the button at the box."],
  [9, "Command lost: the log has the reason."],
])(
  "SWR-CON-091 command lost by cause %i is reported",
  async (value, sentence) => {
    expect(said()).toBe(null);
    await see({}, lost(value));
    expect(said()).toBe(sentence);
  },
);

test("SWR-CON-091 a cause that comes after the state is reported", async () => {
  const [, , taken = makeEntry(1)] = lost(1);
  await see({}, [taken]);
  expect(said()).toBe("Command lost: the log has the reason.");
  await see({}, lost(3));
  expect(said()).toBe(
    "Command lost: another took it by the button at the box.",
  );
});

test("SWR-CON-091 a loss is reported until it was read, also after command was taken again", async () => {
  await see({}, lost(1));
  await see(mine(), []);
  expect(said()).toBe(
    "Command lost: the server did not hear this page in time.",
  );
  fireEvent.click(screen.getByRole("button", { name: "Read" }));
  expect(said()).toBe(null);
});

test("SWR-CON-091 what was given up by hand is no loss", async () => {
  operation.authority.giveUp();
  await see({}, lost(0));
  expect(said()).toBe(null);
});

test("SWR-CON-091 command that a hidden page gave up is reported", async () => {
  hide("hidden");
  await see({}, lost(0));
  expect(said()).toBe("Command lost: this page was hidden.");
});

test("SWR-CON-091 command lost with the session is reported as that", async () => {
  answer = closed;
  await see({}, lost(0));
  await see({}, lost(0));
  expect(said()).toMatch(/^Command lost: the session has ended\. Logged out: /);
});

test("SWR-SESS-035 a server that was started anew is the reason also before the stream shows it", async () => {
  answer = { ...closed, boot_id: "another" };
  await act(() => operation.session.ask());
  expect(said()).toBe(
    "Logged out: the server was started anew, and no session outlives that.",
  );
});

test("SWR-SESS-035 a server that was started anew is reported as the reason", async () => {
  answer = { ...closed, boot_id: "another" };
  await see({ ...mine(), boot_id: "another" });
  await see({ boot_id: "another" }, lost(0));
  expect(said()).toBe(
    "Command lost: the server was started anew. Logged out: the server was started anew, and no session outlives that.",
  );
});

test.each([
  [0, { idle_s: 900 }, /by a logout in another tab, another login or a/],
  [900_000, { idle_s: 900 }, /nothing was commanded or renewed for too long/],
  [60_000, { most_s: 60 }, /the session has lasted as long as one may/],
])(
  "SWR-SESS-035 a session that ends after %i ms says why",
  async (ms, change, reason) => {
    answer = { ...open, ...change };
    await act(() => operation.session.ask());
    await act(() => vi.advanceTimersByTimeAsync(ms));
    answer = closed;
    await act(() => operation.session.ask());
    expect(said()).toMatch(reason);
  },
);

test("SWR-SESS-320 a session that ended by time before the server was started anew names its time", async () => {
  await act(() => vi.advanceTimersByTimeAsync(open.idle_s * 1000));
  await see(mine()); // The first server still runs.
  answer = { ...closed, boot_id: "another" };
  await see({ boot_id: "another" });
  await see({ boot_id: "another" });
  expect(said()).toMatch(/Logged out: nothing was commanded or renewed for/);
});

test("SWR-SESS-320 a session whose time was over when a new server was seen names both", async () => {
  await act(() => vi.advanceTimersByTimeAsync(open.idle_s * 1000));
  answer = { ...closed, boot_id: "another" };
  await act(() => operation.session.ask());
  expect(said()).toBe(
    "Logged out: the server was started anew, or its time was over before.",
  );
});

test("SWR-SESS-320 a session whose time was not over names the start of the server", async () => {
  await act(() => vi.advanceTimersByTimeAsync((open.idle_s - 2) * 1000));
  answer = { ...closed, boot_id: "another" };
  await see({ ...mine(), boot_id: "another" });
  await act(() => operation.session.ask());
  expect(said()).toMatch(/Logged out: the server was started anew, and no/);
});

test("SWR-SESS-320 a page that asks late says that its session ended with the server", async () => {
  fetched.mockRejectedValueOnce(new TypeError("no answer"));
  await see({ ...mine(), boot_id: "another" });
  await act(() => vi.advanceTimersByTimeAsync(open.idle_s * 1000));
  answer = { ...closed, boot_id: "another" };
  await act(() => operation.session.ask());
  expect(said()).toMatch(/Logged out: the server was started anew, and no/);
});

test("SWR-SESS-035 who logs out here is informed of nothing", async () => {
  answer = closed;
  await act(() => operation.session.logOut());
  expect(said()).toBe(null);
});

test("SWR-SESS-035 a session that goes on is informed of nothing, whichever server it is", async () => {
  await see({ ...mine(), boot_id: "another" });
  expect(said()).toBe(null);
});
