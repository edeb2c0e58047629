// SPDX-License-Identifier: Apache-2.0

// A run of scenes in a fresh robot.wasm.

import { readFileSync } from "node:fs";
import { SceneRun } from "../../app/console/src/what_if/scene_run.ts";

export function runOf(file) {
  return new SceneRun(new WebAssembly.Instance(new WebAssembly.Module(readFileSync(file)), {}).exports);
}
