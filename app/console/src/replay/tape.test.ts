// SPDX-License-Identifier: Apache-2.0
// Rule under test: what test_tape.c shows to be written is read as it was.
import { expect, test } from "vitest";
import { Tape, type Row } from "./tape";

function read(...rows: Row[]) {
  const tape = new Tape();
  const hadWords = rows.map((row) => tape.take(row));
  return { tape, hadWords, value: tape.value };
}

test("SWR-REPLAY-018 places are those before the row", () => {
  const first: Row = [0, 0, { a: "x", b: { c: false, d: 1 }, e: null }];
  const { tape, hadWords, value } = read(
    first,
    [-3, 3, true, 2, "y"],
    [2, 4, 2],
  );
  expect(value).toEqual({ a: "x", b: { c: true, d: 2 }, e: "y" });
  expect(hadWords).toEqual([true, true, false]);
  expect(tape.cycle).toBe(5);
});

test("SWR-REPLAY-018 a number goes on, and stands where none is reported", () => {
  const first: Row = [0, 0, { a: 0, b: "x" }];
  expect(read(first, [10, 1, 20], [25]).value).toEqual({ a: 70, b: "x" });
  expect(read(first, [10, 1, 20], [-5, 2, "y"], [20]).value).toEqual({
    a: 70,
    b: "y",
  });
  expect(read(first, [10, 1, 20], [25], [5, 1, 70], [5]).value).toEqual({
    a: 70,
    b: "x",
  });
});

test("SWR-REPLAY-018 after a part that has grown all numbers stand", () => {
  const { value } = read(
    [0, 0, { a: [], b: 1 }],
    [1, 2, 2],
    [-1, 1, ["x", "y"]],
    [1, 4, 2.25],
    [1],
  );
  expect(value).toEqual({ a: ["x", "y"], b: 2.25 });
});

test("SWR-REPLAY-018 a copy goes its own way", () => {
  const { tape } = read([0, 0, { a: 0 }], [1, 1, 2]);
  const copy = tape.copy();
  copy.take([1]);
  expect([tape.value, copy.value]).toEqual([{ a: 2 }, { a: 4 }]);
});
