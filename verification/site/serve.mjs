// SPDX-License-Identifier: Apache-2.0

// A scene at the server in served.wasm: refusals, a login, and a start-up under the pedal. Prints its course as JSON;
// CALLS and ANSWERS become the files that ask.c is compared by.
//
//   node serve.mjs SERVED.wasm ROBOT RENEWALS CALLS ANSWERS

import { writeFileSync } from "node:fs";
import { Server } from "./served.mjs";

const SEED = 7;
const UTC = 1790000000;
const SETTLED_CYCLES = 1000;
// A page renews what it holds at the box, and authority.
const RENEWAL_CYCLES = 500;
const LOOKS = ["status", "robot", "motors", "targeting", "modes", "box", "authority", "trajectory", "program", "nonsense"];

const [file, robot, renewals, calls, answers] = process.argv.slice(2);
const server = new Server(file);
const start = { workphase: "START_UP" };
const status = () => server.ask("GET", "/api/v1/status").json;
const course = {};

const code = server.start(robot, SEED, UTC);
course.before_the_first_cycle = server.ask("GET", "/api/v1/status").status;
server.step(SETTLED_CYCLES);
course.without_login = server.act("/api/v1/workphase", start).status;
course.wrong_login = server.logIn("AAAA-AAAA-AAAA");
server.step(SETTLED_CYCLES);
course.login = server.logIn(code);
course.events = server.ask("GET", "/api/v1/events").status;
server.ask("POST", "/api/v1/box", { estop: "reset" });
server.step(SETTLED_CYCLES);
course.without_authority = server.act("/api/v1/workphase", start).status;
course.authority = server.act("/api/v1/authority").status;
course.start_up = server.act("/api/v1/workphase", start).status;
server.step(SETTLED_CYCLES);
course.homed_without_pedal = status().is_homed;
course.pedal = server.ask("POST", "/api/v1/box", { pedal: "hold" }).status;
const heard = new Set();
const listen = () =>
  server.listen().forEach(({ event, data }) => heard.add(event === "act" ? `act ${data.id} ${data.state}` : event));
for (let renewal = 0; renewal < Number(renewals) && !status().is_homed; renewal++) {
  server.step(RENEWAL_CYCLES);
  server.ask("PUT", "/api/v1/box");
  server.ask("PUT", "/api/v1/authority");
  listen();
}
course.homed = status().is_homed;
server.step(RENEWAL_CYCLES);
listen();
course.heard = [...heard].sort();
course.stop = server.ask("POST", "/api/v1/stop", {}).status;
course.stopped = status().workphase.name;
LOOKS.forEach((name) => server.ask("GET", `/api/v1/${name}`));

writeFileSync(calls, server.calls);
writeFileSync(answers, server.answers);
console.log(JSON.stringify(course));
