// SPDX-License-Identifier: Apache-2.0

// Reads texts, a line each, as scenes and prints of each why it is none.
//
//   node refused_scenes.mjs ROBOT.wasm <TEXTS

import { readFileSync } from "node:fs";
import { readScene } from "../../app/console/src/what_if/scene_text.ts";
import { runOf } from "./scene_module.mjs";

const { vocabulary } = runOf(process.argv[2]);
for (const text of readFileSync(0, "utf8").split("\n").slice(0, -1)) {
  try {
    readScene(text, vocabulary);
    console.log("it is one");
  } catch (error) {
    console.log(error.message);
  }
}
