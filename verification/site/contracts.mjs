// SPDX-License-Identifier: Apache-2.0

// Asks robot.wasm or served.wasm for what it must refuse, each time a fresh one, and prints what it says of it.
//
//   node contracts.mjs MODULE robot|served

import { Robot } from "./robot.mjs";

const ROBOT = {
  order: (robot) => robot.exports.order(),
  step: (robot) => robot.exports.step(),
  happened: (robot) => robot.exports.happened(),
  look: (robot) => robot.exports.look(),
  compareBegin: (robot) => robot.exports.compareBegin(),
  compare: (robot) => robot.exports.compare(),
  block: (robot) => robot.exports.replayBlock(0, 0),
  size: (robot) => {
    robot.say("neuro");
    robot.exports.replay();
    robot.exports.replayBlock(robot.exports.blockMost() + 1, 0);
  },
};
const SERVED = {
  step: (robot) => robot.exports.step(1),
  ask: (robot) => robot.exports.ask(0),
  order: (robot) => robot.exports.order(),
  command: (robot) => robot.exports.command(),
  size: (robot) => {
    robot.say("neuro");
    robot.exports.start(1, 0);
    robot.exports.ask(robot.exports.textSize() + 1);
  },
};

const [file, which] = process.argv.slice(2);

for (const [name, ask] of Object.entries(which === "served" ? SERVED : ROBOT)) {
  const robot = new Robot(file);
  try {
    ask(robot);
    console.log(`${name}: not refused`);
  } catch (error) {
    console.log(`${name}: ${error.constructor.name}: ${robot.text}`);
  }
}
