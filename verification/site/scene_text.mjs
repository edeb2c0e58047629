// SPDX-License-Identifier: Apache-2.0

// Writes scenes by chance and reads them again, damages their texts, and prints as JSON how many came back as they were, how
// many of the damaged ones were refused, and what was wrong.
//
//   node scene_text.mjs ROBOT.wasm COUNT

import { isDeepStrictEqual } from "node:util";
import { readScene, SceneError, writeScene } from "../../app/console/src/what_if/scene_text.ts";
import { runOf } from "./scene_module.mjs";

const CHARACTERS = "0123456789aAzZ:;,=&/-|_ %#é\0";
const NUMBERS = [0, 1, 7, 65536, -1, -2147483648, 4294967295];

const [file, count] = process.argv.slice(2);
const { vocabulary } = runOf(file);
const counts = { equal: 0, refused: 0, wrong: [] };

// Always the same ones: mulberry32.
let state = 7;
function chance(below) {
  state = (state + 0x6d2b79f5) | 0;
  let mixed = Math.imul(state ^ (state >>> 15), state | 1);
  mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
  return ((mixed ^ (mixed >>> 14)) >>> 0) % below;
}

const one = (all) => all[chance(all.length)];

function orderWord(pattern) {
  const word = one(pattern.split("|"));
  return { SLOT: String(chance(10)), WHO: String(1 + chance(9)) }[word] ?? word;
}

function field([name, { count: most }]) {
  const words = [...vocabulary.words.keys()].filter((word) => word.startsWith(`${name} `));
  const values = Array.from({ length: 1 + chance(most) }, () => one(NUMBERS));
  return `${name}=${words.length > 0 && chance(2) === 0 ? one(words).split(" ")[1] : values.join("/")}`;
}

function words() {
  if (chance(2) === 0) {
    return one(vocabulary.orders).map(orderWord);
  }
  const fields = [...vocabulary.fields].filter(() => chance(3) === 0).map(field);
  return [one([...vocabulary.commands.keys()]), ...fields];
}

function scene() {
  let cycle = 0;
  const inputs = Array.from({ length: chance(9) }, () => ({ cycle: (cycle += chance(3) * chance(9999)), words: words() }));
  return { robot: one(["neuro", "prostate"]), seed: one(NUMBERS.filter((number) => number >= 0)), inputs };
}

// A character is another one, too many, or missing.
function damaged(text) {
  const at = chance(text.length);
  return text.slice(0, at) + one([...CHARACTERS, ""]) + text.slice(at + chance(2));
}

function readAgain(text) {
  try {
    return writeScene(readScene(text, vocabulary));
  } catch (error) {
    if (!(error instanceof SceneError) || !(error.place <= text.length)) {
      throw error;
    }
    return null;
  }
}

for (let index = 0; index < Number(count); index++) {
  const made = scene();
  const text = writeScene(made);
  if (isDeepStrictEqual(readScene(text, vocabulary), made)) {
    counts.equal += 1;
  } else {
    counts.wrong.push(text);
  }
  const other = damaged(text);
  const again = readAgain(other);
  if (again === null) {
    counts.refused += 1;
  } else if (again !== other) {
    counts.wrong.push(other);
  }
}
console.log(JSON.stringify(counts));
