// SPDX-License-Identifier: Apache-2.0

// Plays the scenes of hazards in robot.wasm and prints of each, as JSON, which of its expectations are not so, and which of
// them are not so either when its last input is left out: one must be that only the control makes so.
//
//   node scenes.mjs ROBOT.wasm <SCENES       SCENES: JSON, by hazard {scene: TEXT, expects: [EXPECTATION...]}
//
// An expectation begins with a cycle:
//
//   CYCLE driven                   an axis is driven then
//   CYCLE off                      no axis is, from then to the last cycle that the scene speaks of
//   CYCLE TOPIC FIELD is WORDS     as site/watch.h has it
//   CYCLE event NAME [SUBJECT]     has come until then, since the last input
//   CYCLE answer ID KIND STATUS    the same; the first command has the number 1

import { readFileSync } from "node:fs";
import { readScene, writeScene } from "../../app/console/src/what_if/scene_text.ts";
import { runOf } from "./scene_module.mjs";

const FORM = /^(\d+) (driven|off|(?:event|answer) .+|\S+ \S+ is .+)$/;

const run = runOf(process.argv[2]);
const kept = new Map();

function read(expectation) {
  const [, cycle, what] = FORM.exec(expectation) ?? [];
  if (what === undefined) {
    throw new Error(`“${expectation}” is no expectation`);
  }
  return { expectation, cycle: Number(cycle), what };
}

// The robot in the cycle of an input, with all inputs before it. Inputs that scenes have in common are played once.
function stateBefore(scene, at) {
  const { inputs } = scene;
  const key = `${writeScene({ ...scene, inputs: inputs.slice(0, at) })} ${inputs[at].cycle}`;
  if (!kept.has(key)) {
    if (at === 0) {
      run.start(scene);
    } else {
      run.restore(stateBefore(scene, at - 1));
      run.act(inputs[at - 1]);
    }
    run.goTo(inputs[at].cycle, []);
    kept.set(key, run.keep());
  }
  return kept.get(key);
}

// Whether it is so in the last cycle that has passed; of a happening, whether it is in `happened`.
function isSo({ what }, happened) {
  if (what === "driven" || what === "off") {
    return run.isDriven === (what === "driven");
  }
  if (/^(event|answer) /.test(what)) {
    return happened.some((line) => line === what || line.startsWith(`${what} `));
  }
  const [looked, words] = what.split(" is ");
  return run.look(looked) === words;
}

// The expectations that are not so from the state that `run` is in.
function missed(expectations) {
  const end = Math.max(...expectations.map(({ cycle }) => cycle));
  const wrong = new Set();
  const happened = [];
  const judge = () => {
    const now = run.cycle - 1;
    for (const one of expectations) {
      const isDue = one.cycle === now || (one.what === "off" && one.cycle < now);
      if (isDue && !isSo(one, happened)) {
        wrong.add(one.expectation);
      }
    }
  };
  judge();
  while (run.cycle <= end) {
    run.step();
    happened.push(...run.happened());
    judge();
  }
  return [...wrong];
}

function play({ scene: text, expects }) {
  const scene = readScene(text, run.vocabulary);
  const last = scene.inputs.at(-1);
  const expectations = expects.map(read);
  if (expectations.some(({ cycle }) => cycle < last.cycle - 1)) {
    throw new Error("an expectation is of before the last input");
  }
  const before = stateBefore(scene, scene.inputs.length - 1);
  run.restore(before);
  run.act(last);
  const wrong = missed(expectations);
  run.restore(before);
  return { missed: wrong, without: missed(expectations) };
}

function reported(scene) {
  try {
    return play(scene);
  } catch (error) {
    return { missed: [error.message], without: [] };
  }
}

const scenes = JSON.parse(readFileSync(0, "utf8"));
console.log(JSON.stringify(Object.fromEntries(Object.entries(scenes).map(([id, scene]) => [id, reported(scene)]))));
