// SPDX-License-Identifier: Apache-2.0

// Executes the recordings of a run again by robot.wasm and prints how many cycles were equal, or what was not or is missing, and
// exits with 1.
//
//   node replay.mjs ROBOT.wasm FOLDER [BYTES]     BYTES: of the first checkpoint, inverted before

import { readdirSync } from "node:fs";
import { join } from "node:path";
import { Robot } from "./robot.mjs";

const [module, folder, inverted] = process.argv.slice(2);
try {
  const names = readdirSync(folder).filter((name) => name.endsWith(".bsr"));
  const files = names.map((name) => join(folder, name));
  console.log(new Robot(module).replay(files, Number(inverted ?? 0)));
} catch (error) {
  console.log(error.message);
  process.exitCode = 1;
}
