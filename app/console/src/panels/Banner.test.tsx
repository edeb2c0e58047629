// SPDX-License-Identifier: Apache-2.0
// Rule under test: the banner says the state and what is needed next, and never shows old data as new.
import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { ConsoleView } from "../store";
import { makeRobot } from "../testing/robot";
import { Banner } from "./Banner";

const live: ConsoleView = {
  isConnected: true,
  refusal: null,
  freshness: "live",
  ageMs: 0,
  isOutdated: false,
  robot: makeRobot(),
  log: [],
};

afterEach(cleanup);

test("SWR-CON-001 shows what is needed next first, then the state", () => {
  render(<Banner view={live} />);
  expect(screen.getByRole("status").textContent).toBe(
    "Press and hold the pedal.START UP The axes home.",
  );
});

test("SWR-CON-001 waits for control without inventing a state", () => {
  render(<Banner view={{ ...live, robot: null }} />);
  expect(screen.getByRole("status").textContent).toContain(
    "Waiting for control",
  );
});

test("SWR-CON-004 says DATA STALE and how old it is", () => {
  render(<Banner view={{ ...live, freshness: "stale", ageMs: 3200 }} />);
  const text = screen.getByRole("alert").textContent;
  expect(text).toContain("DATA STALE");
  expect(text).toContain("3.2 s");
  expect(text).not.toContain("Press and hold the pedal.");
});

test("SWR-CON-004 says when the server cannot be reached", () => {
  const view: ConsoleView = { ...live, freshness: "stale", isConnected: false };
  render(<Banner view={view} />);
  expect(screen.getByRole("alert").textContent).toContain("cannot be reached");
});

test("SWR-CON-011 says why the server refuses the data", () => {
  const refused = {
    isConnected: false,
    refusal: "Too many consoles are open.",
  };
  render(<Banner view={{ ...live, ...refused, robot: null }} />);
  expect(screen.getByRole("status").textContent).toContain("Too many consoles");
  cleanup();
  render(<Banner view={{ ...live, ...refused, freshness: "stale" }} />);
  expect(screen.getByRole("alert").textContent).toContain("Too many consoles");
});
