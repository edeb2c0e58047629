// SPDX-License-Identifier: Apache-2.0
// Rule under test: what is not known any more is not shown as if it were: no lamp, no authority, no button that commands.
import { act, cleanup, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { RobotState, Session } from "@interface";
import { App } from "../App";
import { TelemetryStore } from "./store";
import { makeOutlook } from "../testing/commander";
import { makeAuthority, makeRobot } from "../testing/robot";
import { FakeSurroundings } from "../testing/surroundings";

const surroundings = new FakeSurroundings();
let store: TelemetryStore;
let page = 0;

const operator: Session = {
  is_open: true,
  name: "anna",
  role: "OPERATOR",
  token: "t",
  idle_s: 900,
  most_s: 900,
  warn_s: 120,
  login: "password",
  boot_id: "boot",
};

const answers: Record<string, object> = {
  "/api/v1/session": operator,
  "/api/v1/modes": makeOutlook("PLANNING", "CALIBRATION"),
};

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("fetch", (path: string, { headers }: RequestInit) => {
    const { "X-Boresight-Page": number } = headers as Record<string, string>;
    page = number === undefined ? page : Number(number);
    return Promise.resolve(new Response(JSON.stringify(answers[path] ?? {})));
  });
});

afterEach(() => {
  store.stop();
  cleanup();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** The page commands. */
async function showCommanding(): Promise<void> {
  store = new TelemetryStore(surroundings);
  store.start();
  render(<App store={store} />);
  const send = async (state: RobotState) => {
    await act(() => vi.advanceTimersByTimeAsync(0));
    act(() => surroundings.stream.send("state", state));
    await act(() => vi.advanceTimersByTimeAsync(0));
  };
  await send(makeRobot());
  await send(
    makeRobot({
      authority: makeAuthority({ state: "held", source: "HTTP", peer: page }),
    }),
  );
}

/** Nothing comes any more. */
async function becomeStale(): Promise<void> {
  surroundings.pass(3000);
  await act(() => vi.advanceTimersByTimeAsync(200));
  screen.getByText("DATA STALE");
}

function lamps(): (string | undefined)[][] {
  return [...document.querySelectorAll<HTMLElement>(".lamps .lamp")].map(
    (lamp) => [
      lamp.dataset.level,
      lamp.querySelector(".lamp-word")?.textContent,
    ],
  );
}

function live(): string[] {
  return [...document.querySelectorAll(".panels .order button")]
    .filter((button) => !(button as HTMLButtonElement).disabled)
    .map((button) => button.textContent);
}

test("SWR-CON-061 under stale data all lamps but that of the data are unknown", async () => {
  await showCommanding();
  await becomeStale();
  const [data, ...others] = lamps();
  expect(data).toEqual(["fault", "STALE"]);
  expect(others.length).toBeGreaterThan(6);
  for (const other of others) {
    expect(other).toEqual(["unknown", "UNKNOWN"]);
  }
});

test("SWR-CON-061 under stale data it is not known who commands", async () => {
  await showCommanding();
  screen.getByText("This page commands.");
  await becomeStale();
  expect(screen.queryByText("This page commands.")).toBeNull();
  screen.getByText("The commanding client is not known.");
  expect(screen.queryByRole("button", { name: /command/i })).toBeNull();
});

test("SWR-CON-061 under stale data no button commands, and it is said why", async () => {
  await showCommanding();
  expect(live()).not.toEqual([]);
  await becomeStale();
  expect(live()).toEqual([]);
  expect(
    screen.getAllByText("What the robot does is not known now.").length,
  ).toBeGreaterThan(0);
});
