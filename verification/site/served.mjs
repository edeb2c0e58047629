// SPDX-License-Identifier: Apache-2.0

// The server in served.wasm, asked as a browser would. site/served/served.h says what it offers. All calls are kept as
// ask.c reads them, and all answers as it prints them.

import { readFileSync } from "node:fs";

const PAGE = 7;
const END_OF_HEAD = "\r\n\r\n";

export class Server {
  calls = "";
  answers = "";
  #cookie = "";
  #token = "";
  #acts = 0;

  constructor(file) {
    this.exports = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(file)), {}).exports;
  }

  // Returns the code of the first login.
  start(robot, seed, utc) {
    this.calls += `start ${seed} ${utc} ${robot.length}\n${robot}`;
    this.#say(`${robot}\0`);
    if (!this.exports.start(seed, utc)) {
      throw new Error(`there is no robot ${robot}`);
    }
    return this.#hear(this.#bytes(this.exports.answer()).indexOf(0));
  }

  step(cycles) {
    this.calls += `step ${cycles}\n`;
    this.exports.step(cycles);
  }

  ask(method, path, body) {
    const text = body === undefined ? "" : JSON.stringify(body);
    const fields = { Host: "127.0.0.1", "X-Boresight-Page": PAGE };
    if (this.#token !== "") {
      Object.assign(fields, { Cookie: this.#cookie, "X-Boresight-Token": this.#token });
    }
    if (body !== undefined) {
      Object.assign(fields, { "Content-Type": "application/json", "Content-Length": text.length });
    }
    const head = Object.entries(fields).map(([name, value]) => `\r\n${name}: ${value}`);
    return this.#send(`${method} ${path} HTTP/1.1${head.join("")}${END_OF_HEAD}${text}`);
  }

  logIn(code) {
    const { status, json } = this.ask("POST", "/api/v1/session", { code });
    this.#token = json.token ?? "";
    return status;
  }

  act(path, fields = {}) {
    this.#acts += 1;
    return this.ask("POST", path, { id: this.#acts, ...fields });
  }

  // Data of the stream so far.
  listen() {
    this.calls += "listen\n";
    const messages = this.#hear(this.exports.listen()).split("\n\n").slice(0, -1);
    return messages.map((message) => ({
      event: /^event: (.*)$/m.exec(message)[1],
      data: JSON.parse(/^data: (.*)$/m.exec(message)[1]),
    }));
  }

  #bytes(address) {
    return new Uint8Array(this.exports.memory.buffer, address);
  }

  #say(words) {
    const bytes = new TextEncoder().encode(words);
    this.#bytes(this.exports.text()).set(bytes);
    return bytes.length;
  }

  #hear(size) {
    const words = new TextDecoder().decode(this.#bytes(this.exports.answer()).subarray(0, size));
    this.answers += `${size}\n${words}`;
    return words;
  }

  #send(request) {
    const size = this.#say(request);
    this.calls += `ask ${size}\n${request}`;
    const answer = this.#hear(this.exports.ask(size));
    const end = answer.indexOf(END_OF_HEAD);
    const head = answer.slice(0, end);
    const reported = answer.slice(end + END_OF_HEAD.length);
    this.#cookie = /^Set-Cookie: ([^;]*)/m.exec(head)?.[1] ?? this.#cookie;
    return { status: Number(head.split(" ")[1]), json: reported === "" ? null : JSON.parse(reported) };
  }
}
