// SPDX-License-Identifier: Apache-2.0

// Asks robot.wasm for what it must refuse, each time a fresh one, and prints what it says of it.
//
//   node contracts.mjs ROBOT.wasm

import { Robot } from "./robot.mjs";

const WRONG = {
  order: (robot) => robot.exports.order(),
  step: (robot) => robot.exports.step(),
  block: (robot) => robot.exports.replayBlock(0, 0),
  size: (robot) => {
    robot.say("neuro");
    robot.exports.replay();
    robot.exports.replayBlock(robot.exports.blockMost() + 1, 0);
  },
};

for (const [name, ask] of Object.entries(WRONG)) {
  const robot = new Robot(process.argv[2]);
  try {
    ask(robot);
    console.log(`${name}: not refused`);
  } catch (error) {
    console.log(`${name}: ${error.constructor.name}: ${robot.text}`);
  }
}
