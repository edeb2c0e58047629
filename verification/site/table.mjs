// SPDX-License-Identifier: Apache-2.0

// The robot in the file of the page, by its own interface, app/console/src/site/served_robot.ts: logged in, it takes command, homes,
// is registered and goes to each target under the pedal, which is released in between. Its time passes as fast as it may.
// Reads registration and targets as JSON; prints where the treatment point came to be at each, scanner coordinates in mm.
//
//   node table.mjs PAGE ROBOT

import { readFileSync } from "node:fs";
import { expand } from "../../app/console/src/site/expand.ts";
import { ServedRobot } from "../../app/console/src/site/served_robot.ts";

const SEED = 7;
const UTC = 1790000000;
const PAGE_NUMBER = "7";
// A page renews what it holds, authority and pedal; the box lets go after three times as long.
const RENEWAL_CYCLES = 500;
// Most renewals of a motion, and a bound against hanging.
const MOST_RENEWALS = 240;

const [file, name] = process.argv.slice(2);
const packed = /id="?robot"?[^>]*>\s*([\w+/=]+)/.exec(readFileSync(file, "utf8"))[1];
const robot = new ServedRobot(new WebAssembly.Module(expand(Buffer.from(packed, "base64"))));
const identity = { "X-Boresight-Page": PAGE_NUMBER };
let acts = 0;

function ask(method, path, body) {
  const headers = body === undefined ? identity : { ...identity, "Content-Type": "application/json" };
  const answered = robot.ask({
    method,
    address: `/api/v1/${path}`,
    headers,
    body: body === undefined ? null : JSON.stringify(body),
  });
  if (answered.status >= 300) {
    throw new Error(`${method} ${path}: ${answered.status} ${answered.body}`);
  }
  return answered.body === "" ? null : JSON.parse(answered.body);
}

function act(path, fields = {}) {
  acts += 1;
  return ask("POST", path, { id: acts, ...fields });
}

function live() {
  robot.step(RENEWAL_CYCLES);
  ["box", "authority"].forEach((path) => ask("PUT", path));
}

// Outcome of the last act.
function ended() {
  const reported = robot.listen().filter(({ type }) => type === "act");
  return reported.map(({ data }) => JSON.parse(data)).find(({ id, state }) => id === acts && state !== "accepted");
}

function underPedal(path, fields) {
  robot.listen();
  act(path, fields);
  live();
  ask("POST", "box", { pedal: "hold" });
  let end;
  for (let renewal = 0; end === undefined && renewal < MOST_RENEWALS; renewal++) {
    live();
    end = ended();
  }
  ask("POST", "box", { pedal: "drop" });
  live();
  if (end?.state !== "done") {
    throw new Error(`${path} ${JSON.stringify(fields)}: ${JSON.stringify(end)}`);
  }
}

function reach({ pose, entry }) {
  act("workphase", { workphase: "PLANNING" });
  act("workphase", { workphase: "TARGETING" });
  if (entry !== null) {
    act("targeting/entry", { point_mm: entry });
  }
  act("targeting/target", { matrix: pose });
  underPedal("workphase", { workphase: "MOVE_TO_TARGET" });
  const { scanner_treatment: matrix } = ask("GET", "targeting");
  return [matrix[3], matrix[7], matrix[11]];
}

const { registration, targets } = JSON.parse(readFileSync(0, "utf8"));
robot.start(name, SEED, UTC);
identity["X-Boresight-Token"] = ask("GET", "session").token;
robot.step(RENEWAL_CYCLES);
ask("GET", "events");
act("authority");
underPedal("workphase", { workphase: "START_UP" });
act("workphase", { workphase: "PLANNING" });
act("workphase", { workphase: "CALIBRATION" });
act("targeting/registration", { matrix: registration });
const reached = targets.map(reach);
console.log(JSON.stringify({ seconds: robot.cycles / 1000, reached }));
