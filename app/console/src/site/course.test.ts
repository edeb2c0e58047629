// SPDX-License-Identifier: Apache-2.0
// Rule under test: what was done is kept whole, or not at all, and a link of it is not too long.
import { expect, test } from "vitest";
import type { Input } from "../what_if/scene_text";
import { Course, MOST_INPUTS, MOST_LINK } from "./course";

const START = { robot: "neuro", seed: 7 };

function courseOf(...lines: string[]): Course {
  const course = new Course();
  const inputs = lines.map((line): Input => {
    const [cycle, ...words] = line.split(" ");
    return { cycle: Number(cycle), words };
  });
  inputs.forEach((input) => course.add([input]));
  return course;
}

test("SWR-SITE-030 a link has all that was done", () => {
  const course = courseOf("5 STOP id=7", "5 pedal press", "9 pedal press");
  expect(course.write(START)).toBe(
    "robot=neuro&seed=7&inputs=5:STOP,id=7;5:pedal,press;9:pedal,press",
  );
});

test("SWR-SITE-030 renewals between others that are near enough are left out, and the last one never", () => {
  const kept = courseOf(
    "0 keep 7",
    "0 keep 7",
    ...["400 keep 7", "900 keep 7", "1300 keep 7", "1301 keep 8"],
    ...["1302 keep 7", "1303 keep 7", "1303 keep 7"],
  ).inputs.map(({ cycle, words }) => `${cycle} ${words[1]}`);
  expect(kept).toEqual([
    "0 7",
    "900 7",
    "1300 7",
    "1301 8",
    "1302 7",
    "1303 7",
  ]);
});

test("SWR-SITE-030 too many inputs are not kept, nor those behind one that nobody knows", () => {
  const course = new Course();
  const input = { cycle: 1, words: ["pedal", "press"] };
  course.add(Array.from({ length: MOST_INPUTS }, () => input));
  expect(course.problem).toBeNull();
  course.add([input]);
  const reason = "More than 10,000 inputs were given, and are not kept.";
  expect(course.problem).toBe(reason);
  expect(() => course.write(START)).toThrow(reason);
  const lost = courseOf("1 pedal press");
  lost.add(null);
  lost.add([input]);
  expect([lost.problem, lost.inputs]).toEqual([reason, []]);
});

test("SWR-SITE-030 a link that is too long is refused with its length", () => {
  const course = new Course();
  const input = { cycle: 1, words: ["pedal", "press"] };
  course.add(Array.from({ length: MOST_LINK / 10 }, () => input));
  expect(() => course.write(START)).toThrow(
    "The link would have 42,025 characters; 30,000 is the most.",
  );
});
