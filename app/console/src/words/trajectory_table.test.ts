// SPDX-License-Identifier: Apache-2.0
// Rule under test: a table is drawn as control reads it, and what cannot be drawn is not.
import { expect, test } from "vitest";
import { lineOf, readTrajectory } from "./trajectory_table";

test("SWR-CON-034 columns are found by their names, in any order", () => {
  const text = "head mm,time ms,head mm/s\r\n1,0,0\r\n2,500,0\r\n\r\n";
  expect(readTrajectory(text)).toEqual({
    rows: 2,
    durationS: 0.5,
    ways: [
      {
        axis: "head",
        unit: "mm",
        points: [
          [0, 1],
          [0.5, 2],
        ],
      },
    ],
  });
});

test.each([
  "",
  "time s,yaw deg",
  "yaw deg\n1",
  "time s\n1",
  "time s,yaw deg\nx,1",
])("SWR-CON-034 nothing is drawn of %j", (text) =>
  expect(readTrajectory(text)).toBeNull(),
);

test("SWR-CON-034 a number that is none leaves a gap", () => {
  const table = readTrajectory("time s,yaw deg\n0,1\n1,?\n2,3\n");
  expect(table?.ways[0]?.points).toEqual([
    [0, 1],
    [2, 3],
  ]);
});

test("SWR-CON-034 the line of a refusal is the line of the text", () => {
  expect(lineOf("a\r\nb\nc", "line 2")).toBe("b");
  expect(lineOf("a", "line 9")).toBeNull();
  expect(lineOf("a", undefined)).toBeNull();
});
