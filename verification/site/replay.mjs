// SPDX-License-Identifier: Apache-2.0

// Executes a recording again by robot.wasm and prints how many cycles were equal, or what was not, and exits with 1.
//
//   node replay.mjs ROBOT.wasm FILE [BYTES]     BYTES: of the first checkpoint, inverted before

import { Robot } from "./robot.mjs";

const [module, recording, inverted] = process.argv.slice(2);
try {
  console.log(new Robot(module).replay(recording, Number(inverted ?? 0)));
} catch (error) {
  console.log(error.message);
  process.exitCode = 1;
}
