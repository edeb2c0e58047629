// SPDX-License-Identifier: Apache-2.0

// Plays a scene by robot.wasm; scene.c says what the lines in and out are.
//
//   node scene.mjs ROBOT.wasm ROBOT SEED CYCLES <SCENE

import { readFileSync } from "node:fs";
import { Robot } from "./robot.mjs";

const SECOND_CYCLES = 1000;
const FNV_BASIS = 2166136261;
const FNV_PRIME = 16777619;
// In the words of the outputs.
const ANSWER_COUNT = 1;
const ANSWERS = 4;
const ANSWER = { words: 20, id: 0, kind: 4, status: 5 };
const COMMAND_WORDS = 6;

const [file, name, seed, cycles] = process.argv.slice(2);
const robot = new Robot(file);
const { exports } = robot;

function words(address, count) {
  return new Uint32Array(exports.memory.buffer, address, count);
}

function act(what) {
  const [kind, ...rest] = what.split(" ");
  if (kind === "order") {
    robot.say(rest.join(" "));
    exports.order();
    process.stdout.write(robot.text);
  } else {
    words(exports.command(), COMMAND_WORDS).set(rest.map(Number));
  }
}

function printAnswers(cycle, outputs) {
  for (let index = 0; index < outputs[ANSWER_COUNT]; index++) {
    const at = ANSWERS + index * ANSWER.words;
    console.log(`${cycle} answer ${outputs[at + ANSWER.id]} ${outputs[at + ANSWER.kind]} ${outputs[at + ANSWER.status]}`);
  }
}

function add(hash, all) {
  let sum = hash;
  for (let at = 0; at < all.length; at++) {
    sum = Math.imul(sum ^ all[at], FNV_PRIME);
  }
  return sum;
}

const scene = readFileSync(0, "utf8").split("\n").filter((line) => line !== "");
robot.say(name);
if (!exports.start(Number(seed))) {
  throw new Error(`there is no robot ${name}`);
}
const inputs = words(exports.inputs(), exports.inputsSize() / 4);
const outputs = words(exports.outputs(), exports.outputsSize() / 4);
let hash = FNV_BASIS;
for (let cycle = 0; cycle < Number(cycles); cycle++) {
  while (scene.length > 0 && Number.parseInt(scene[0]) === cycle) {
    act(scene.shift().replace(/^\d+ /, ""));
  }
  exports.step();
  hash = add(add(hash, inputs), outputs);
  printAnswers(cycle, outputs);
  if ((cycle + 1) % SECOND_CYCLES === 0) {
    console.log(`${cycle + 1} hash ${hash >>> 0}`);
  }
}
