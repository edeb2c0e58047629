// SPDX-License-Identifier: Apache-2.0
// Rule under test: what xz has packed for a page is expanded to the same bytes, and nothing else is taken.
import { execFileSync } from "node:child_process";
import { expect, test } from "vitest";
import { expand } from "./expand";

const pack = (bytes: Uint8Array, pb = 0) =>
  new Uint8Array(
    execFileSync(
      "xz",
      ["--format=lzma", `--lzma1=preset=9e,lc=3,lp=0,pb=${String(pb)}`, "-c"],
      { input: bytes },
    ),
  );

/** Has literals, matches near and far, repeated distances, and long runs. */
function mixture(): Uint8Array {
  let seed = 7;
  const draw = (below: number) => {
    seed = (seed * 1103515245 + 12345) % 2147483648;
    return Math.floor(seed / 65536) % below;
  };
  const bytes = Array.from({ length: 3000 }, () => draw(256));
  while (bytes.length < 300_000) {
    const from = draw(bytes.length - 400);
    const length = draw(3) === 0 ? draw(400) : draw(9);
    bytes.push(...bytes.slice(from, from + length), draw(4));
    bytes.push(...Array<number>(draw(5)).fill(bytes[from] ?? 0));
  }
  return new Uint8Array(bytes);
}

test("SWR-SITE-015 what xz has packed is expanded to the same bytes", () => {
  for (const bytes of [mixture(), new Uint8Array(5000), new Uint8Array()]) {
    expect(Buffer.compare(expand(pack(bytes)), bytes)).toBe(0);
  }
});

test("SWR-SITE-015 what is packed otherwise or cut off is refused", () => {
  const bytes = mixture();
  expect(() => expand(pack(bytes, 2))).toThrow("packed otherwise");
  expect(() => expand(pack(bytes).subarray(0, 900))).toThrow("cut off");
});
