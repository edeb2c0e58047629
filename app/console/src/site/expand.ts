// SPDX-License-Identifier: Apache-2.0
// Expands what `xz --format=lzma --lzma1=lc=3,lp=0,pb=0` has packed (LZMA specification, 7-zip.org/sdk.html). It packs a
// module a tenth smaller than what the browser expands itself.

const PROPERTIES = 3; // (pb * 5 + lp) * 9 + lc
const HEADER = 14; // Properties, size of the dictionary, of the text, and a byte that is always 0.
const END = 0xffffffff; // As a distance.

// Where the chances of each kind of decision begin.
const IS_MATCH = 0;
const IS_REPEATED = 12;
const IS_OLDER = 24; // By how many distances: three times twelve.
const IS_LONG = 60;
const LENGTH = 72;
const REPEATED_LENGTH = LENGTH + 274;
const SLOT = REPEATED_LENGTH + 274;
const DISTANCE = SLOT + 256;
const ALIGN = DISTANCE + 128;
const LITERAL = ALIGN + 16;

/** Decides bit by bit by what was decided before. */
class RangeDecoder {
  private readonly chances = new Uint16Array(LITERAL + 8 * 0x300).fill(1024);
  private range = 0xffffffff;
  private code = 0;
  private at = HEADER;

  private readonly bytes: Uint8Array;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
    for (let i = 0; i < 4; i++) {
      this.code = this.code * 256 + this.next();
    }
  }

  private next(): number {
    const byte = this.bytes[this.at++];
    if (byte === undefined) {
      throw new Error("The module is cut off.");
    }
    return byte;
  }

  private normalize(): void {
    if (this.range < 0x1000000) {
      this.range *= 256;
      this.code = this.code * 256 + this.next();
    }
  }

  bit(index: number): number {
    this.normalize();
    const chance = this.chances[index] ?? 0;
    const bound = (this.range >>> 11) * chance;
    if (this.code < bound) {
      this.range = bound;
      this.chances[index] = chance + ((2048 - chance) >> 5);
      return 0;
    }
    this.range -= bound;
    this.code -= bound;
    this.chances[index] = chance - (chance >> 5);
    return 1;
  }

  tree(base: number, bits: number): number {
    let symbol = 1;
    for (let i = 0; i < bits; i++) {
      symbol = symbol * 2 + this.bit(base + symbol);
    }
    return symbol - 2 ** bits;
  }

  /** The lowest bit comes first. */
  reverseTree(base: number, bits: number): number {
    let node = 1;
    let value = 0;
    for (let i = 0; i < bits; i++) {
      const bit = this.bit(base + node);
      node = node * 2 + bit;
      value += bit * 2 ** i;
    }
    return value;
  }

  direct(bits: number): number {
    let value = 0;
    for (let i = 0; i < bits; i++) {
      this.normalize();
      this.range = Math.floor(this.range / 2);
      const bit = Number(this.code >= this.range);
      this.code -= bit * this.range;
      value = value * 2 + bit;
    }
    return value;
  }

  length(base: number): number {
    if (this.bit(base) === 0) {
      return 2 + this.tree(base + 2, 3);
    }
    return this.bit(base + 1) === 0
      ? 10 + this.tree(base + 10, 3)
      : 18 + this.tree(base + 18, 8);
  }

  distance(length: number): number {
    const slot = this.tree(SLOT + Math.min(length - 2, 3) * 64, 6);
    if (slot < 4) {
      return slot;
    }
    const bits = (slot >> 1) - 1;
    const start = (2 + (slot & 1)) * 2 ** bits;
    return slot < 14
      ? start + this.reverseTree(DISTANCE + start - slot, bits)
      : start + this.direct(bits - 4) * 16 + this.reverseTree(ALIGN, 4);
  }

  /** `unlike`: the byte at the last distance, where the bytes before came from there, which this one differs from. */
  literal(before: number, unlike: number | undefined): number {
    const base = LITERAL + 0x300 * (before >> 5);
    let symbol = 1;
    for (let i = 7; unlike !== undefined && i >= 0; i--) {
      const expected = (unlike >> i) & 1;
      const bit = this.bit(base + 256 * (1 + expected) + symbol);
      symbol = symbol * 2 + bit;
      if (bit !== expected) {
        break;
      }
    }
    while (symbol < 256) {
      symbol = symbol * 2 + this.bit(base + symbol);
    }
    return symbol - 256;
  }
}

/** The bytes written so far, and the state that the next decision rests on. */
class Expansion {
  readonly bytes: number[] = [];
  private readonly decoder: RangeDecoder;
  /** The last ones, the newest first. */
  private readonly distances = [0, 0, 0, 0];
  /** Which kinds of step were the last ones: literals below 7. */
  private state = 0;

  constructor(packed: Uint8Array) {
    this.decoder = new RangeDecoder(packed);
  }

  private follow(afterLiteral: number, otherwise: number): void {
    this.state = this.state < 7 ? afterLiteral : otherwise;
  }

  private isSo(base: number): boolean {
    return this.decoder.bit(base + this.state) === 1;
  }

  private back(): number {
    return this.bytes[this.bytes.length - 1 - (this.distances[0] ?? 0)] ?? 0;
  }

  private literal(): number {
    const { bytes, state } = this;
    const unlike = state < 7 ? undefined : this.back();
    this.state = Math.max(0, state - (state < 10 ? 3 : 6));
    return this.decoder.literal(bytes.at(-1) ?? 0, unlike);
  }

  /** From an older distance, which becomes the newest. */
  private repeated(): number {
    let older = 0;
    if (this.isSo(IS_OLDER)) {
      older = this.isSo(IS_OLDER + 12) ? (this.isSo(IS_OLDER + 24) ? 3 : 2) : 1;
    } else if (!this.isSo(IS_LONG)) {
      this.follow(9, 11);
      return 1;
    }
    this.distances.unshift(...this.distances.splice(older, 1));
    this.follow(8, 11);
    return this.decoder.length(REPEATED_LENGTH);
  }

  private matched(): number {
    const length = this.decoder.length(LENGTH);
    this.distances.unshift(this.decoder.distance(length));
    this.distances.pop();
    this.follow(7, 10);
    return length;
  }

  /** Returns false at the end. */
  step(): boolean {
    if (!this.isSo(IS_MATCH)) {
      this.bytes.push(this.literal());
      return true;
    }
    const length = this.isSo(IS_REPEATED) ? this.repeated() : this.matched();
    if (this.distances[0] === END) {
      return false;
    }
    for (let i = 0; i < length; i++) {
      this.bytes.push(this.back());
    }
    return true;
  }
}

/**
 * Throws an Error when it is packed otherwise or cut off.
 *
 * @satisfies SWR-SITE-015
 */
export function expand(packed: Uint8Array): Uint8Array<ArrayBuffer> {
  if (packed[0] !== PROPERTIES) {
    throw new Error("The module is packed otherwise.");
  }
  const expansion = new Expansion(packed);
  while (expansion.step());
  return new Uint8Array(expansion.bytes);
}
