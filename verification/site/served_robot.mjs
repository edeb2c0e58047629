// SPDX-License-Identifier: Apache-2.0

// The robot of a page by its own interface, app/console/src/site/served_robot.ts: a course from a snapshot, the same one again
// from the same snapshot, and another one from it. Prints whether they are equal.
//
//   node served_robot.mjs SERVED.wasm ROBOT

import { readFileSync } from "node:fs";
import { ServedRobot } from "../../app/console/src/site/served_robot.ts";

const SEED = 7;
const UTC = 1790000000;
const CYCLES = 2000;

const [file, name] = process.argv.slice(2);
const robot = new ServedRobot(new WebAssembly.Module(readFileSync(file)));
const get = (address) => robot.ask({ method: "GET", address, headers: {}, body: null });

function course(cycles) {
  robot.step(cycles);
  const reported = robot.listen();
  const seen = ["status", "motors", "box"].map((path) => get(`/api/v1/${path}`).body);
  return JSON.stringify({ cycles: robot.cycles, reported, seen });
}

robot.start(name, SEED, UTC);
const session = JSON.parse(get("/api/v1/session").body);
get("/api/v1/events");
robot.step(CYCLES);
robot.listen();
const snapshot = robot.snapshot();
const first = course(CYCLES);
robot.step(CYCLES);
robot.restore(snapshot);
const again = course(CYCLES);
robot.restore(snapshot);
const other = course(CYCLES + 1);
console.log(JSON.stringify({ role: session.role, again: first === again, other: first === other, reported: first.length > 1000 }));
