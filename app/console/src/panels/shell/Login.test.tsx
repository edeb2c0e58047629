// SPDX-License-Identifier: Apache-2.0
// Rule under test: the console logs in and out, says who is logged in, and no session ends by surprise.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Session } from "@interface";
import { ASK_MS, SessionStore } from "../../state/session";
import { Login } from "./Login";

const nobody: Session = {
  is_open: false,
  name: null,
  role: null,
  token: null,
  idle_s: 0,
  most_s: 0,
  warn_s: 120,
  login: "password",
  boot_id: "boot",
};
const anna: Session = {
  ...nobody,
  is_open: true,
  name: "anna",
  role: "OPERATOR",
  token: "t0ken",
  idle_s: 900,
  most_s: 43200,
};

let answers: Record<string, () => Response>;
const fetched = vi.fn((_path: string, options: RequestInit) =>
  Promise.resolve(answers[options.method ?? ""]?.() ?? new Response("{}")),
);

function says(session: Session): () => Response {
  return () => new Response(JSON.stringify(session));
}

function refuses(status: number, headers: Record<string, string>) {
  return () =>
    new Response(JSON.stringify({ detail: "It is refused." }), {
      status,
      headers,
    });
}

function lastOf(method: string): RequestInit | undefined {
  return fetched.mock.calls
    .map(([, options]) => options)
    .findLast((options) => options.method === method);
}

async function show(session: Session): Promise<void> {
  answers = { GET: says(session) };
  render(<Login store={new SessionStore()} />);
  await act(() => vi.advanceTimersByTimeAsync(0));
}

async function press(name: RegExp): Promise<void> {
  fireEvent.click(screen.getByRole("button", { name }));
  await act(() => vi.advanceTimersByTimeAsync(0));
}

function type(label: RegExp, value: string): void {
  fireEvent.change(screen.getByLabelText(label), { target: { value } });
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("fetch", fetched);
  fetched.mockClear();
});

afterEach(() => {
  cleanup();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("SWR-SESS-010 who is logged in is shown, and goes out with the token", async () => {
  await show(anna);
  screen.getByText("anna");
  expect(screen.queryByRole("alert")).toBeNull();
  answers.DELETE = says(nobody);
  await press(/Log out/);
  expect(lastOf("DELETE")?.headers).toEqual({ "X-Boresight-Token": "t0ken" });
  screen.getByText("Not logged in");
});

test("SWR-SESS-010 name and password are sent, and forgotten by the page", async () => {
  await show(nobody);
  await press(/Log in/);
  type(/Name/, "anna");
  type(/Password/, "correct-horse");
  answers.POST = says(anna);
  await press(/Log in/);
  expect(lastOf("POST")?.body).toBe(
    '{"name":"anna","password":"correct-horse"}',
  );
  screen.getByText("anna");
  expect(document.body.innerHTML).not.toContain("correct-horse");
});

test("SWR-SESS-010 where there is no account the code is asked for", async () => {
  await show({ ...nobody, login: "code" });
  await press(/Log in/);
  type(/Code/, " abcd-efgh-2345 ");
  answers.POST = says(anna);
  await press(/Log in/);
  expect(lastOf("POST")?.body).toBe('{"code":"ABCD-EFGH-2345"}');
});

test("SWR-SESS-010 what was refused stays to be mended, but for a password", async () => {
  await show({ ...nobody, login: "code" });
  await press(/Log in/);
  type(/Code/, "ABCD-EFGH-2346");
  answers.POST = refuses(401, {});
  await press(/Log in/);
  expect(screen.getByLabelText(/Code/)).toHaveProperty(
    "value",
    "ABCD-EFGH-2346",
  );
  cleanup();
  await show(nobody);
  await press(/Log in/);
  type(/Name/, "anna");
  type(/Password/, "x");
  await press(/Log in/);
  expect(screen.getByLabelText(/Name/)).toHaveProperty("value", "anna");
  expect(screen.getByLabelText(/Password/)).toHaveProperty("value", "");
});

test("SWR-SESS-010 where nobody can log in this is said", async () => {
  await show({ ...nobody, login: "none" });
  screen.getByText("Nobody can log in here.");
  expect(screen.queryByRole("button")).toBeNull();
});

test("SWR-SESS-033 a refusal is reported in the server's words alone", async () => {
  await show(nobody);
  await press(/Log in/);
  type(/Name/, "anna");
  type(/Password/, "x");
  answers.POST = refuses(429, { "Retry-After": "8" });
  await press(/Log in/);
  expect(screen.getByRole("alert").textContent).toBe("It is refused.");
});

test("SWR-SESS-010 a session that ends soon says so, and can go on", async () => {
  await show(anna);
  answers.GET = says({ ...anna, idle_s: 120 });
  await act(() => vi.advanceTimersByTimeAsync(ASK_MS));
  screen.getByText(/The session ends in 120 s/);
  answers.PUT = says(anna);
  await press(/Stay logged in/);
  expect(lastOf("PUT")?.headers).toEqual({ "X-Boresight-Token": "t0ken" });
  expect(screen.queryByRole("alert")).toBeNull();
});

test("SWR-SESS-010 a session that is too old cannot go on", async () => {
  await show({ ...anna, idle_s: 60, most_s: 60 });
  screen.getByText(/Log in again/);
  expect(screen.queryByRole("button", { name: /Stay/ })).toBeNull();
});

test("SWR-SESS-010 a session that has ended is not shown any more", async () => {
  await show(anna);
  answers.GET = says(nobody);
  await act(() => vi.advanceTimersByTimeAsync(ASK_MS));
  screen.getByText("Not logged in");
});
