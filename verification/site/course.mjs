// SPDX-License-Identifier: Apache-2.0

// Acts on the robot of a page as a browser does, makes the link of what was done, and plays it in a page of another time.
// Prints as JSON the words of the outputs that are others there, at the end or in the cycles after it, each as often as it is;
// of the pedal when it was held for the last time, and long after no page held on to it; what is said to differ with an e-stop, and
// with what comes anyhow; and the inputs.
//
//   node course.mjs SERVED.wasm ROBOT [LEFT_OUT]    LEFT_OUT: the input of this number is not played

import { readFileSync } from "node:fs";
import { Course } from "../../app/console/src/site/course.ts";
import { answerOf, inputAt } from "../../app/console/src/site/question.ts";
import { ServedRobot } from "../../app/console/src/site/served_robot.ts";
import { readScene } from "../../app/console/src/what_if/scene_text.ts";

const SEED = 7;
const UTC = 1790000000;
const AFTER_CYCLES = 300;
const RENEWAL_CYCLES = 500;
const RENEWALS = 9;
const PAGE_NUMBER = 4_000_000_007; // A number of more than 31 bits.

const [file, name, leftOut] = process.argv.slice(2);
const module = new WebAssembly.Module(readFileSync(file));
const course = new Course();
const identity = {
  "X-Boresight-Page": String(PAGE_NUMBER),
  "Content-Type": "application/json",
};
let acts = 0;

function begin(scene, utc) {
  const robot = new ServedRobot(module);
  robot.start(scene.robot, scene.seed, utc);
  return robot;
}

const live = begin({ robot: name, seed: SEED }, UTC);

function pass(cycles) {
  live.step(cycles);
  course.add(live.done());
}

function ask(method, path, body = null) {
  const answered = live.ask({
    method,
    address: `/api/v1/${path}`,
    headers: identity,
    body: body && JSON.stringify(body),
  });
  course.add(live.done());
  return JSON.parse(answered.body);
}

function act(path, fields = {}) {
  acts += 1;
  return ask("POST", path, { id: acts, ...fields });
}

function hold(renewals) {
  ask("POST", "box", { pedal: "hold" });
  for (let renewal = 0; renewal < renewals; renewal++) {
    ask("PUT", "box");
    ask("PUT", "box"); // Twice in a cycle, as in a pause.
    pass(RENEWAL_CYCLES);
    ask("PUT", "authority");
  }
}

pass(1);
identity["X-Boresight-Token"] = ask("GET", "session").token;
pass(RENEWAL_CYCLES);
act("authority");
act("workphase", { workphase: "START_UP" });
hold(RENEWALS);
ask("POST", "box", { pedal: "drop" });
pass(RENEWAL_CYCLES);
ask("POST", "box", { slot: 3, card_fault: "silent" });
pass(RENEWAL_CYCLES);
ask("POST", "stop", {});
pass(RENEWAL_CYCLES);
hold(1);
const held = live.copy().look("state pedal");
pass(4 * RENEWAL_CYCLES);
const left = live.copy().look("state pedal");
act("workphase", { workphase: "STAND_BY" });
pass(RENEWAL_CYCLES); // Until the log has it.

const scene = readScene(course.write({ robot: name, seed: SEED }), live.vocabulary);

// As a page plays a link.
function played(inputs) {
  const robot = begin(scene, UTC + 1000);
  for (const input of inputs) {
    robot.step(input.cycle - robot.cycles);
    robot.act(input);
  }
  robot.step(live.cycles - robot.cycles);
  return robot.copy();
}

const one = live.copy();
const other = played(scene.inputs.filter((_, number) => String(number) !== leftOut));
const words = ({ outputs }) => new Int32Array(outputs.slice().buffer);
const differences = {};
for (let cycle = 0; cycle < AFTER_CYCLES; cycle++) {
  const others = words(other);
  words(one).forEach((word, place) => {
    if (word !== others[place]) {
      const what = `${place}: ${word - others[place]}`;
      differences[what] = (differences[what] ?? 0) + 1;
    }
  });
  one.step();
  other.step();
}
const reset = inputAt(live.cycles, "estop reset", live.vocabulary);
const answerTo = (input, inputs) => answerOf({ input, seconds: 1 }, inputs, live.copy(), live.copy());
console.log(
  JSON.stringify({
    differences,
    held,
    left,
    answers: [answerTo(" estop  pull", []), answerTo("estop reset", [reset])],
    inputs: scene.inputs.map(({ words: said }) => said.join(" ")),
  }),
);
