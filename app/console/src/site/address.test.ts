// SPDX-License-Identifier: Apache-2.0
// Rule under test: the address of the page chooses its robot.
import { expect, test } from "vitest";
import {
  addressIn,
  addressOf,
  askedIn,
  choiceIn,
  isOther,
  linkOf,
} from "./address";

test("SWR-SITE-012 the address names robot and seed, and what it does not say is as usual", () => {
  const usual = { robot: "neuro", seed: 1, scene: null };
  expect(choiceIn("")).toEqual(usual);
  expect(choiceIn("#charts")).toEqual(usual);
  expect(choiceIn("#seed=-3")).toEqual(usual);
  expect(choiceIn(`${addressOf("prostate")}&seed=42`)).toEqual({
    robot: "prostate",
    seed: 42,
    scene: null,
  });
});

const SCENE = "#robot=neuro&seed=7&inputs=200:pedal,press;300:pedal,release";

test("SWR-SITE-025 an address with inputs names a scene, as it stands there", () => {
  expect(choiceIn(SCENE).scene).toBe(SCENE.slice(1));
  expect(choiceIn("#robot=neuro&seed=7").scene).toBeNull();
});

test("SWR-SITE-012 only another robot is another page", () => {
  const neuro = choiceIn("");
  expect(isOther("#robot=prostate", neuro)).toBe(true);
  expect(isOther("#robot=neuro", neuro)).toBe(false);
  expect(isOther("#charts", choiceIn("#robot=prostate"))).toBe(false);
});

test("SWR-SITE-025 another scene is another page, and a view of the one that is played is none", () => {
  const played = choiceIn(SCENE);
  expect(isOther(SCENE, choiceIn(""))).toBe(true);
  expect(isOther(`${SCENE};400:pedal,press`, played)).toBe(true);
  expect(isOther("#robot=neuro", played)).toBe(true);
  expect(isOther(SCENE, played)).toBe(false);
  expect(isOther("#charts", played)).toBe(false);
});

test("SWR-SITE-012 a choice has an address by which it is chosen again", () => {
  ["", "#robot=prostate&seed=42", SCENE].map(choiceIn).forEach((choice) => {
    expect(choiceIn(addressIn(choice))).toEqual(choice);
  });
});

test("SWR-SITE-033 a link may ask a question of its scene, which it has after it was read", () => {
  const scene = SCENE.slice(1);
  const asked = { cycle: 250, input: "card 3 silent", seconds: 7 };
  const { hash } = new URL(linkOf(scene, asked));
  expect(askedIn(hash.slice(1))).toEqual([scene, asked]);
  expect(isOther(hash, choiceIn(SCENE))).toBe(true);
  expect(askedIn(scene)).toEqual([scene, null]);
  const long = `${scene}&at=99999999&if=card,3,silent&for=7`;
  expect(askedIn(long)).toEqual([long, null]);
});
