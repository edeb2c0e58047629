// SPDX-License-Identifier: Apache-2.0
// Reads an MCAP file with the library of the format, twice: from its beginning to its end, and by its indexes. Every
// checksum is compared, every message with its schema. Prints what is in it as JSON; exit 1 and a sentence if something
// is wrong.
//
//     node verification/system/support/read_mcap.mjs FILE          (packages: .tools/mcap)
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { crc32, zstdDecompressSync } from "node:zlib";

const require = createRequire(new URL("../../../.tools/mcap/", import.meta.url));
const { McapIndexedReader, McapStreamReader } = require("@mcap/core");

const bytes = readFileSync(process.argv[2]);
const decompressHandlers = { zstd: (packed) => new Uint8Array(zstdDecompressSync(packed)) };

// From its beginning to its end.
function stream() {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  reader.append(bytes);
  const records = [];
  for (let record; (record = reader.nextRecord()); ) records.push(record);
  assert.ok(reader.done(), "the file goes on, or ends before its end");
  return records;
}

// By its indexes.
async function indexed() {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const messages = [];
  for await (const message of reader.readMessages()) messages.push(message);
  return { reader, messages };
}

function parse(data) {
  return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(data));
}

// The members that a schema names, and no others, of the types that it names.
function fits(schema, value, where) {
  if (schema.type !== "object") {
    const type = schema.type === "integer" ? "number" : schema.type;
    assert.equal(typeof value, type, where);
    return;
  }
  assert.deepEqual(Object.keys(value), Object.keys(schema.properties), where);
  for (const [name, inner] of Object.entries(schema.properties)) fits(inner, value[name], `${where} ${name}`);
}

function checkDataCrc(records) {
  const end = records.find((record) => record.type === "DataEnd");
  const length = bytes.lastIndexOf(Buffer.from([0x0f, 4, 0, 0, 0, 0, 0, 0, 0]), Number(footer(records).summaryStart));
  assert.equal(end.dataSectionCrc, crc32(bytes.subarray(0, length)), "checksum of the data");
}

function footer(records) {
  return records.find((record) => record.type === "Footer");
}

const records = stream();
const { reader, messages } = await indexed();
const found = records.filter((record) => record.type === "Message");
checkDataCrc(records);
assert.notEqual(footer(records).summaryCrc, 0);
assert.equal(messages.length, found.length, "as many messages by the indexes");
assert.equal(reader.statistics.messageCount, BigInt(found.length));
assert.equal(reader.statistics.chunkCount, reader.chunkIndexes.length);

const channels = new Map();
for (const channel of reader.channelsById.values()) {
  const schema = reader.schemasById.get(channel.schemaId);
  assert.deepEqual([channel.messageEncoding, schema.encoding], ["json", "jsonschema"]);
  channels.set(channel.id, { topic: channel.topic, name: schema.name, schema: parse(schema.data), messages: [] });
}
let before = 0n;
for (const message of found) {
  const channel = channels.get(message.channelId);
  const value = parse(message.data);
  fits(channel.schema, value, channel.topic);
  assert.ok(message.logTime >= before, "times go back");
  assert.equal(message.sequence, channel.messages.length);
  before = message.logTime;
  channel.messages.push({ time_us: Number(message.logTime / 1000n), value });
}
for (const channel of channels.values()) delete channel.schema;
console.log(
  JSON.stringify({
    chunks: reader.chunkIndexes.length,
    notes: records.filter((record) => record.type === "Metadata").map((note) => [note.name, Object.fromEntries(note.metadata)]),
    channels: Object.fromEntries([...channels.values()].map(({ topic, ...channel }) => [topic, channel])),
  }),
);
