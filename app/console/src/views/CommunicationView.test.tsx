// SPDX-License-Identifier: Apache-2.0
// Rule under test: each client is shown with its traffic, and disconnected only on a second question, by a commanding page.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
  within,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Communication, Connection } from "@interface";
import { makeCommander, type Commander } from "../testing/commander";
import { makeAuthority, makeRobot, makeViewProperties } from "../testing/robot";
import { ASK_AGAIN_MS, CommunicationView } from "./CommunicationView";

const PATH = "/api/v1/communication";
const display: Connection = {
  number: 7,
  address: "127.0.0.1:41000",
  port: "transforms",
  dialect: "crtk",
  has_authority: false,
  is_waiting: true,
  keep_alive: true,
  age_s: 130,
  messages_in: 3,
  messages_out: 900,
  bytes_in: 174,
  bytes_out: 95_400,
  errors: 2,
  last_message: null,
  status: null,
  silent_s: 12,
};
const commander: Connection = {
  ...display,
  number: 8,
  address: "127.0.0.1:42000",
  has_authority: true,
  is_waiting: false,
  last_message: "CMD_0001",
};
const reported: Communication = {
  connections: [display, commander],
  pages: [{ number: 5, account: "bert", has_authority: false, age_s: 3 }],
  ports: [],
};
let server: Commander;

beforeEach(async () => {
  server = await makeCommander("OPERATOR");
  server.answers[PATH] = { body: reported };
});

afterEach(() => {
  cleanup();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

async function show(authority = server.authority): Promise<void> {
  const robot = makeRobot({ authority });
  render(
    <CommunicationView {...makeViewProperties(server.operation, robot)} />,
  );
  await act(() => Promise.resolve());
  await screen.findByText("bert");
}

function row(address: string): HTMLElement {
  return screen.getByRole("row", { name: new RegExp(address) });
}

async function press(name: string): Promise<void> {
  fireEvent.click(screen.getByRole("button", { name }));
  await act(() => Promise.resolve());
}

test("SWR-CON-037 each connection is reported with its traffic", async () => {
  await show();
  expect(row("41000").textContent).toBe(
    "127.0.0.1:41000transforms, crtk, waits for a placeno3 (174 B)900 (95.4 kB)2none yetnone yet12 s2 minDisconnect…",
  );
  expect(row("42000").textContent).toContain("commands");
  expect(row("42000").textContent).toContain("CMD_0001");
});

test("SWR-CON-037 each page is shown with its account", async () => {
  await show();
  const pages = screen.getByRole("region", { name: "Pages" });
  expect(within(pages).getAllByRole("row")[1]?.textContent).toBe("bertno3 s");
});

test("SWR-CON-037 this page knows itself", async () => {
  const { number } = server.operation.page;
  const pages = [{ number, account: "anna", has_authority: true, age_s: 0 }];
  server.answers[PATH] = { body: { ...reported, pages } };
  const robot = makeRobot({ authority: server.authority });
  render(
    <CommunicationView {...makeViewProperties(server.operation, robot)} />,
  );
  expect(await screen.findByText("anna, this page")).toBeTruthy();
});

test("SWR-CON-112 the status that a client has sent is shown", async () => {
  const status = "IMAGER 1 OK Valid Target";
  server.answers[PATH] = {
    body: { ...reported, connections: [display, { ...commander, status }] },
  };
  await show();
  expect(within(row("42000")).getByText(status)).toBeTruthy();
  expect(within(row("41000")).queryByText(status)).toBeNull();
});

test("SWR-CON-037 a connection is ended after a second question", async () => {
  server.answers[`${PATH}/7/disconnect`] = {
    body: { ...reported, connections: [commander] },
  };
  await show();
  await press("Disconnect 127.0.0.1:41000?");
  expect(server.acts()).toEqual([]);
  await press("Disconnect");
  expect(server.acts()).toEqual([{ path: `${PATH}/7/disconnect`, body: null }]);
  expect(screen.queryByText("127.0.0.1:41000")).toBeNull();
});

test("SWR-CON-037 nothing is ended when the second question is denied", async () => {
  await show();
  await press("Disconnect 127.0.0.1:41000?");
  await press("Cancel");
  expect(server.acts()).toEqual([]);
});

test("SWR-CON-037 why a connection is not ended is the server's to say", async () => {
  const detail = "This connection commands the robot.";
  server.answers[`${PATH}/8/disconnect`] = { status: 409, body: { detail } };
  await show();
  await press("Disconnect 127.0.0.1:42000?");
  await press("Disconnect");
  expect(screen.getByRole("alert").textContent).toBe(detail);
  expect(row("42000")).toBeTruthy();
});

test("SWR-CON-037 a connection is asked no longer whether it is there", async () => {
  const connections = [{ ...display, keep_alive: false }];
  server.answers[`${PATH}/7/keep-alive`] = {
    body: { ...reported, connections },
  };
  await show();
  const box = () =>
    within(row("41000")).getByRole<HTMLInputElement>("checkbox");
  fireEvent.click(box());
  await act(() => Promise.resolve());
  expect(server.puts()).toEqual([
    { path: `${PATH}/7/keep-alive`, body: { on: false } },
  ]);
  expect(box().checked).toBe(false);
});

test("SWR-CON-037 who does not command ends nothing", async () => {
  await show(makeAuthority());
  expect(screen.getByText("Take command first.")).toBeTruthy();
  const buttons = screen.getAllByRole<HTMLButtonElement>("button");
  expect(buttons.map(({ disabled }) => disabled)).toEqual([true, true]);
});

test("SWR-CON-037 it is asked again every second, and not after", async () => {
  vi.useFakeTimers();
  const robot = makeRobot({ authority: server.authority });
  const count = () => server.questions().filter((path) => path === PATH).length;
  render(
    <CommunicationView {...makeViewProperties(server.operation, robot)} />,
  );
  expect(count()).toBe(1);
  await act(() => vi.advanceTimersByTimeAsync(2 * ASK_AGAIN_MS));
  expect(count()).toBe(3);
  cleanup();
  await vi.advanceTimersByTimeAsync(2 * ASK_AGAIN_MS);
  expect(count()).toBe(3);
});

test("SWR-CON-037 nobody is said to be nobody, and no answer to be none", async () => {
  server.answers[PATH] = { body: { connections: [], pages: [], ports: [] } };
  const robot = makeRobot();
  render(
    <CommunicationView {...makeViewProperties(server.operation, robot)} />,
  );
  expect(screen.getAllByText("Not known yet.")).toHaveLength(2);
  expect(await screen.findByText("Nobody is connected.")).toBeTruthy();
  expect(screen.getByText("Nobody is logged in.")).toBeTruthy();
});
