// SPDX-License-Identifier: Apache-2.0
// Reads what app/replay/data/tape.h writes and describes: a value of which each row says only what is new.

/** The cycles since the row before, negative where numbers stand; then pairs of a distance and a value. */
export type Row = readonly [number, ...unknown[]];

/** Where a value is held. */
interface Place {
  holder: Record<string, unknown>;
  key: string;
}

function isContainer(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null;
}

/** Depth first, as they are counted. */
function placesOf(root: Place): Place[] {
  const value = root.holder[root.key];
  return isContainer(value)
    ? [root].concat(
        ...Object.keys(value).map((key) => placesOf({ holder: value, key })),
      )
    : [root];
}

export class Tape {
  /** Cycle of the last row. */
  cycle = 0;
  /** Cycle of the last one with numbers. */
  counted = 0;
  private root: Place = { holder: { whole: null }, key: "whole" };
  private places = placesOf(this.root);
  /** Changes of the numbers that continue by themselves, for each cycle. */
  private rates = new Map<number, number>();

  /** It changes with the next row. */
  get value(): unknown {
    return this.root.holder[this.root.key];
  }

  copy(): Tape {
    const copy = new Tape();
    copy.cycle = this.cycle;
    copy.counted = this.counted;
    copy.root.holder = { whole: structuredClone(this.value) };
    copy.places = placesOf(copy.root);
    copy.rates = new Map(this.rates);
    return copy;
  }

  /** Whether it has anything but numbers. */
  take([cycles, ...pairs]: Row): boolean {
    this.cycle += Math.abs(cycles);
    const since = this.cycle - this.counted;
    const others = new Map(cycles < 0 ? [] : this.rates);
    let place = 0;
    let [hasWords, isRebuilt] = [false, false];
    for (let index = 0; index < pairs.length; index += 2) {
      place += pairs[index] as number;
      const value = pairs[index + 1];
      const { holder, key } = this.places[place]!;
      const before = holder[key];
      const areNumbers =
        typeof value === "number" && typeof before === "number";
      const rate = areNumbers ? (value - before) / since : 0;
      others.delete(place);
      this.rates.delete(place);
      if (rate !== 0 && Number.isInteger(rate)) {
        this.rates.set(place, rate);
      }
      // Later rows change what is in it, and this one may be read again.
      holder[key] = isContainer(value) ? structuredClone(value) : value;
      hasWords ||= !areNumbers;
      isRebuilt ||= isContainer(value) || isContainer(before);
    }
    if (cycles >= 0) {
      this.goOn(others, since);
      this.counted = this.cycle;
    }
    if (isRebuilt) {
      this.places = placesOf(this.root);
      this.rates.clear();
    }
    return hasWords;
  }

  /** Continues the numbers that were not given. */
  private goOn(rates: ReadonlyMap<number, number>, cycles: number): void {
    for (const [place, rate] of rates) {
      const { holder, key } = this.places[place]!;
      holder[key] = (holder[key] as number) + rate * cycles;
    }
  }
}
