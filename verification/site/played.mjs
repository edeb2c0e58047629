// SPDX-License-Identifier: Apache-2.0

// Plays a scene in served.wasm, as a page does, and in robot.wasm, and prints in words the first cycle in which they differ;
// at the end how many cycles were played, and what happened in them.
//
//   node played.mjs ROBOT.wasm SERVED.wasm SCENE CYCLES [INSTEAD]    INSTEAD: a scene for robot.wasm, which differs

import { readFileSync } from "node:fs";
import { readScene } from "../../app/console/src/what_if/scene_text.ts";
import { SceneRun } from "../../app/console/src/what_if/scene_run.ts";
import { runOf } from "./scene_module.mjs";

const UTC = 1790000000;

const [file, served, text, cycles, instead = text] = process.argv.slice(2);
const run = runOf(file);
const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(served)), {});
const page = new SceneRun({
  ...exports,
  start: (seed) => exports.start(seed, UTC),
  step: () => exports.step(1),
  outputsSize: () => run.outputs.length,
});

const scene = readScene(text, page.vocabulary);
const other = readScene(instead, run.vocabulary);
const happened = [];
page.start(scene);
run.start(other);
page.compareBegin();
while (page.cycle < Number(cycles)) {
  page.goTo(page.cycle + 1, scene.inputs);
  run.goTo(run.cycle + 1, other.inputs);
  const lines = page.compare(run);
  if (lines.length > 0) {
    console.log(lines.join("\n"));
    process.exit(1);
  }
  happened.push(...page.happened());
}
console.log([`${page.cycle} cycles`, ...happened].join("\n"));
