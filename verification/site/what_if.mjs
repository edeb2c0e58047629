// SPDX-License-Identifier: Apache-2.0

// Run with another input from a cycle on: prints the first difference, in words, in robot.wasm.
//
//   node what_if.mjs ROBOT.wasm SCENE CHANGED CYCLE CYCLES    of SCENE, so many cycles from CYCLE on; both are scenes

import { readScene } from "../../app/console/src/what_if/scene_text.ts";
import { whatIf } from "../../app/console/src/what_if/scene_run.ts";
import { runOf } from "./scene_module.mjs";

const [file, text, changed, cycle, cycles] = process.argv.slice(2);
const run = runOf(file);
const other = runOf(file);
const scene = readScene(text, run.vocabulary);
run.start(scene);
run.goTo(Number(cycle), scene.inputs);
const lines = whatIf(run, other, scene.inputs, readScene(changed, run.vocabulary).inputs, Number(cycles));
lines.forEach((line) => console.log(line));
