// SPDX-License-Identifier: Apache-2.0

// robot.wasm in Node: words, and recordings that are executed again. site/exports.h says what it offers.

import { readFileSync } from "node:fs";
import { zstdDecompressSync } from "node:zlib";

// As app/recording/format/recording.h has it; bytes of the header and of a block.
const HEADER = { size: 256, robot: 80, structures: 96, layout: 120, frameLayout: 128, run: 136 };
const BLOCK = { magic: 0x4b425342, prefix: 64, cycle: 8, records: 12, rawSize: 16, size: 20 };
const TRAILER = { magic: 0x4e455342, runEnd: 0x45525342, blocks: 4 };
const CHUNK = 1024;
const CHECKPOINT = 3;

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

  // Executes the one run whose recordings these are, from cycle 0 to its end; returns how many cycles were equal. Throws at
  // the first that was not, and at the first that is missing. inverted: so many bytes of the first checkpoint are, before.
  replay(files, inverted = 0) {
    const first = (recording) => recording.readUInt32LE(HEADER.size + BLOCK.cycle);
    const recordings = files.map((file) => readFileSync(file)).sort((one, other) => first(one) - first(other));
    let hasEnded = false;
    this.cycle = 0;
    recordings.forEach((recording, index) => {
      if (recording.readBigUInt64LE(HEADER.run) !== recordings[0].readBigUInt64LE(HEADER.run)) {
        throw new Error("the recordings are of two runs");
      }
      this.#check(recording, index === 0);
      hasEnded = this.#replayBlocks(recording, index === 0 ? inverted : 0);
    });
    if (!hasEnded) {
      throw new Error(`the run has no end: the last cycle is ${this.cycle - 1}`);
    }
    if (this.exports.replayed() !== this.cycle) {
      throw new Error(`${this.exports.replayed()} of ${this.cycle} cycles could be replayed`);
    }
    return this.cycle;
  }

  // Returns whether the run ends with it.
  #replayBlocks(recording, inverted) {
    let at = HEADER.size;
    let blocks = 0;
    while (recording.readUInt32LE(at) === BLOCK.magic) {
      at = this.#replayBlock(recording, at, blocks === 0 ? inverted : 0);
      blocks++;
    }
    const magic = recording.readUInt32LE(at);
    if (![TRAILER.magic, TRAILER.runEnd].includes(magic) || recording.readUInt32LE(at + TRAILER.blocks) !== blocks) {
      throw new Error("the recording is cut short");
    }
    return magic === TRAILER.runEnd;
  }

  // Its robot and its structures must be those of the module.
  #check(recording, isFirst) {
    this.say(recording.toString("latin1", HEADER.robot, HEADER.structures).split("\0")[0]);
    const { replay, inputsSize, outputsSize, checkpointSize, layout, frameLayout } = this.exports;
    const crc = isFirst ? replay() : this.crc;
    const structures = [crc, inputsSize(), outputsSize(), checkpointSize()];
    this.crc = crc;
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
    if (field("cycle") !== this.cycle) {
      throw new Error(`cycles ${this.cycle} to ${field("cycle") - 1} are missing`);
    }
    this.cycle += field("records") - (raw[0] === CHECKPOINT ? 1 : 0);
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
