// SPDX-License-Identifier: Apache-2.0

// Plays a scene by robot.wasm; scene.c says what the lines in and out are.
//
//   node scene.mjs ROBOT.wasm LAYOUT ROBOT SEED CYCLES <SCENE
//
// LAYOUT says where the outputs have their answers, as scene.c prints it.

import { readFileSync } from "node:fs";
import { Robot } from "./robot.mjs";

const SECOND_CYCLES = 1000;
const FNV_BASIS = 2166136261;
const FNV_PRIME = 16777619;
const COMMAND_WORDS = 6;

const [file, layout, name, seed, cycles] = process.argv.slice(2);
const answer = JSON.parse(layout);
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
  for (let index = 0; index < outputs[answer.count]; index++) {
    const at = answer.first + index * answer.words;
    console.log(`${cycle} answer ${outputs[at + answer.id]} ${outputs[at + answer.kind]} ${outputs[at + answer.status]}`);
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
