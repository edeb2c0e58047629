// SPDX-License-Identifier: Apache-2.0
// Rule under test: the address of the page chooses its robot.
import { expect, test } from "vitest";
import { addressOf, choiceIn, isOther } from "./address";

test("SWR-SITE-012 the address names robot and seed, and what it does not say is as usual", () => {
  const usual = { robot: "neuro", seed: 1 };
  expect(choiceIn("")).toEqual(usual);
  expect(choiceIn("#charts")).toEqual(usual);
  expect(choiceIn("#seed=-3")).toEqual(usual);
  expect(choiceIn(`${addressOf("prostate")}&seed=42`)).toEqual({
    robot: "prostate",
    seed: 42,
  });
});

test("SWR-SITE-012 only another robot is another page", () => {
  expect(isOther("#robot=prostate", "neuro")).toBe(true);
  expect(isOther("#robot=neuro", "neuro")).toBe(false);
  expect(isOther("#charts", "prostate")).toBe(false);
});
