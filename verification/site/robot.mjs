// SPDX-License-Identifier: Apache-2.0

// robot.wasm in Node: words, and recordings that are executed again. site/exports.h says what it offers.

import { readFileSync } from "node:fs";
import { zstdDecompressSync } from "node:zlib";

// As app/recording/recording.h has it; bytes of the header and of a block.
const HEADER = { size: 256, robot: 80, structures: 96, layout: 120, frameLayout: 128 };
const BLOCK = { magic: 0x4b425342, prefix: 64, cycle: 8, records: 12, rawSize: 16, size: 20 };
const TRAILER = { magic: 0x4e455342, blocks: 4 };
const CHUNK = 1024;

export class Robot {
  constructor(file) {
    this.exports = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(file)), {}).exports;
  }

  bytes(address, size) {
    return new Uint8Array(this.exports.memory.buffer, address, size);
  }

  say(words) {
    const bytes = new TextEncoder().encode(`${words}\0`);
    this.bytes(this.exports.text(), bytes.length).set(bytes);
  }

  get text() {
    const bytes = new Uint8Array(this.exports.memory.buffer, this.exports.text());
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  // Executes a whole recording; returns how many cycles were equal. Throws at the first that was not. inverted: so
  // many bytes of the first checkpoint are, before.
  replay(file, inverted = 0) {
    const recording = readFileSync(file);
    this.#begin(recording);
    let at = HEADER.size;
    let blocks = 0;
    while (recording.readUInt32LE(at) === BLOCK.magic) {
      at = this.#replayBlock(recording, at, blocks === 0 ? inverted : 0);
      blocks++;
    }
    if (recording.readUInt32LE(at) !== TRAILER.magic || recording.readUInt32LE(at + TRAILER.blocks) !== blocks) {
      throw new Error("the recording is cut short");
    }
    return this.exports.replayed();
  }

  // Its robot and its structures must be those of the module.
  #begin(recording) {
    this.say(recording.toString("latin1", HEADER.robot, HEADER.structures).split("\0")[0]);
    const { replay, inputsSize, outputsSize, checkpointSize, layout, frameLayout } = this.exports;
    const structures = [replay(), inputsSize(), outputsSize(), checkpointSize()];
    const fits =
      structures.every((own, index) => own >>> 0 === recording.readUInt32LE(HEADER.structures + 4 * index)) &&
      BigInt.asUintN(64, layout()) === recording.readBigUInt64LE(HEADER.layout) &&
      frameLayout() >>> 0 === recording.readUInt32LE(HEADER.frameLayout);
    if (!fits) {
      throw new Error("the recording is of another build");
    }
  }

  // Returns where the next one begins.
  #replayBlock(recording, at, inverted) {
    const field = (name) => recording.readUInt32LE(at + BLOCK[name]);
    const payload = at + BLOCK.prefix + 4 * Math.ceil(field("size") / CHUNK);
    const end = payload + field("size");
    const raw = zstdDecompressSync(recording.subarray(payload, end));
    if (raw.length !== field("rawSize") || raw.length > this.exports.blockMost()) {
      throw new Error(`the block of cycle ${field("cycle")} is damaged`);
    }
    for (let index = 1; index <= inverted; index++) {
      raw[index] ^= 0xff;
    }
    this.bytes(this.exports.block(), raw.length).set(raw);
    const taken = this.exports.replayBlock(raw.length, field("cycle"));
    if (taken !== field("records")) {
      throw new Error(taken < 0 ? this.text : `the block of cycle ${field("cycle")} holds ${taken} records`);
    }
    return end;
  }
}
