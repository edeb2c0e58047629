// SPDX-License-Identifier: Apache-2.0
// Rule under test: a robot in a page lives by the time of the world, at the pace that was chosen.
import { expect, test } from "vitest";
import { MOST_MS, Pace } from "./pace";

test("SWR-SITE-009 as many cycles are due as ms have passed, and none is lost between", () => {
  const pace = new Pace(100);
  const due = [100, 100.4, 120.3, 120.9, 121.5].map((ms) => pace.due(ms));
  expect(due).toEqual([0, 0, 20, 0, 1]);
});

test("SWR-SITE-009 time that the page was not run for has not passed", () => {
  const pace = new Pace(0);
  expect(pace.due(3_600_000)).toBe(MOST_MS);
  expect(pace.due(3_600_020)).toBe(20);
});

test("SWR-SITE-009 cycles that a request has waited for are not due again", () => {
  const pace = new Pace(0);
  pace.spend(30);
  expect([20, 40, 60].map((ms) => pace.due(ms))).toEqual([0, 10, 20]);
});

test("SWR-SITE-014 a pace is a share of the time of the world, from now on", () => {
  const pace = new Pace(0);
  pace.set(0, 10);
  pace.spend(3);
  expect(pace.due(100)).toBe(0);
  pace.set(0.1, 200);
  expect(pace.due(255)).toBe(5);
  pace.set(2, 255);
  expect(pace.due(265)).toBe(20);
});
