// SPDX-License-Identifier: Apache-2.0

// Reads a recording by recorded.wasm, as the page does, and prints the JSON that its page shows; of a file that is refused what
// is said instead, and exits with 1. Without FILE: what is said when it is to go on with none.
//
//   node recorded.mjs RECORDED.wasm [FILE]

import { readFileSync } from "node:fs";
import { RecordedFile } from "../../app/console/src/recorded/recorded_file.ts";

const [module, file] = process.argv.slice(2);
const recorded = new RecordedFile(new WebAssembly.Module(readFileSync(module)));
try {
  const show = () => undefined;
  process.stdout.write(file === undefined ? recorded.finish(show) : recorded.read(file, readFileSync(file), show));
} catch ({ message }) {
  console.log(message);
  process.exitCode = 1;
}
