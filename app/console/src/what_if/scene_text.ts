// SPDX-License-Identifier: Apache-2.0
// Inputs of a robot, as a text that fits the fragment of a link:
//
//   robot=neuro&seed=7&inputs=100:WORKPHASE,workphase=START_UP;200:pedal,press
//
// An input has its cycle and its words: an order of the simulated box, or the kind of a command and what its fields are,
// of several numbers with slashes between them. A kind has fields of its own beside those that all have. Which there are the module of the robot says (site/watch.h).

export interface Input {
  /** It is done before this cycle, of which the first is 0. */
  cycle: number;
  words: string[];
}

export interface Scene {
  robot: string;
  seed: number;
  inputs: Input[];
}

interface Field {
  /** In words of 32 bits. */
  offset: number;
  count: number;
}

/** The inputs that there are. */
export interface Vocabulary {
  /** The patterns of orders, by words. */
  orders: string[][];
  commands: Map<string, number>;
  /** Fields of all commands by "FIELD", of one kind by "KIND.FIELD". */
  fields: Map<string, Field>;
  /** Numbers of the words of a field, by "FIELD WORD". */
  words: Map<string, number>;
}

/** Why a text is no scene, and where: behind so many characters. */
export class SceneError extends Error {
  readonly place: number;

  constructor(place: number, reason: string) {
    super(`At character ${place + 1}: ${reason}`);
    this.place = place;
  }
}

const WORD_BYTES = 4;
const MOST = 0xffffffff;
const LEAST = -0x80000000;
const CYCLES: [number, number] = [0, MOST];

export function readVocabulary(text: string): Vocabulary {
  const vocabulary: Vocabulary = {
    orders: [],
    commands: new Map(),
    fields: new Map(),
    words: new Map(),
  };
  for (const line of text.split("\n")) {
    const [kind, ...rest] = line.split(" ");
    const [name = "", ...more] = rest;
    const [first, second] = more;
    if (kind === "order") {
      vocabulary.orders.push(rest);
    } else if (kind === "command") {
      vocabulary.commands.set(name, Number(first));
    } else if (kind === "field") {
      const offset = Number(first) / WORD_BYTES;
      vocabulary.fields.set(name, { offset, count: Number(second) });
    } else if (kind === "word") {
      vocabulary.words.set(`${name} ${first}`, Number(second));
    }
  }
  return vocabulary;
}

/** A number as it is written by writeScene(), and in no other way; NaN: it is none. */
function numberOf(text: string, [least, most]: [number, number]): number {
  const number = /^(0|-?[1-9][0-9]*)$/.test(text) ? Number(text) : NaN;
  return number >= least && number <= most ? number : NaN;
}

function fitsWord(word: string, pattern: string): boolean {
  return pattern.split("|").some((one) => {
    if (one === "SLOT") {
      return /^([0-9]|[a-z]{1,15})$/.test(word);
    }
    return one === "WHO"
      ? numberOf(word, [1, MOST]) > 0
      : one === word ||
          (/^-?\d+$/.test(one) && !Number.isNaN(numberOf(word, [LEAST, MOST])));
  });
}

function isOrder(words: string[], vocabulary: Vocabulary): boolean {
  return vocabulary.orders.some(
    (pattern) =>
      pattern.length === words.length &&
      pattern.every((one, at) => fitsWord(words[at] ?? "", one)),
  );
}

/** How the vocabulary names a field of commands of a kind; undefined: they have none of this name. */
function fieldOf(
  kind: string,
  name: string,
  vocabulary: Vocabulary,
): string | undefined {
  return [name, `${kind}.${name}`].find((one) => vocabulary.fields.has(one));
}

function fieldsOf(kind: string, vocabulary: Vocabulary): string[] {
  return [...vocabulary.fields.keys()]
    .filter((name) => !name.includes(".") || name.startsWith(`${kind}.`))
    .map((name) => name.replace(`${kind}.`, ""));
}

/** The numbers of a field that is given as text; null: it cannot have them. */
function valuesOf(
  name: string,
  text: string,
  vocabulary: Vocabulary,
): number[] | null {
  const values = text.split("/").map((one) => {
    return (
      vocabulary.words.get(`${name} ${one}`) ?? numberOf(one, [LEAST, MOST])
    );
  });
  const count = vocabulary.fields.get(name)?.count ?? 0;
  return values.length > count || values.some(Number.isNaN) ? null : values;
}

function checkFields(
  kind: string,
  fields: string[],
  place: number,
  vocabulary: Vocabulary,
): void {
  const seen = new Set<string>();
  for (const field of fields) {
    const [name = "", value = "", ...more] = field.split("=");
    const known = fieldOf(kind, name, vocabulary);
    if (known === undefined || more.length > 0) {
      const names = fieldsOf(kind, vocabulary).join(", ");
      throw new SceneError(
        place,
        `“${field}” is not FIELD=VALUE with one of ${names}.`,
      );
    }
    if (seen.has(name)) {
      throw new SceneError(place, `${name} is given twice.`);
    }
    if (valuesOf(known, value, vocabulary) === null) {
      const at = place + name.length + 1;
      throw new SceneError(at, `“${value}” is nothing that ${name} can be.`);
    }
    seen.add(name);
    place += field.length + 1;
  }
}

/** `CYCLE:WORDS`, which stands behind `place` characters of what is read; throws a SceneError. */
export function readInput(
  text: string,
  place: number,
  vocabulary: Vocabulary,
): Input {
  const colon = text.indexOf(":");
  const cycle = numberOf(text.slice(0, Math.max(colon, 0)), CYCLES);
  if (Number.isNaN(cycle)) {
    throw new SceneError(place, `“${text}” does not begin with CYCLE:.`);
  }
  const words = text.slice(colon + 1).split(",");
  const [kind = "", ...fields] = words;
  const behind = place + colon + 1;
  if (vocabulary.commands.has(kind)) {
    checkFields(kind, fields, behind + kind.length + 1, vocabulary);
  } else if (!isOrder(words, vocabulary)) {
    throw new SceneError(
      behind,
      `“${words.join(" ")}” is no order of the box and no command.`,
    );
  }
  return { cycle, words };
}

function readInputs(
  text: string,
  place: number,
  vocabulary: Vocabulary,
): Input[] {
  const inputs: Input[] = [];
  for (const one of text === "" ? [] : text.split(";")) {
    const input = readInput(one, place, vocabulary);
    if (input.cycle < (inputs.at(-1)?.cycle ?? 0)) {
      throw new SceneError(
        place,
        `cycle ${input.cycle} stands behind a later one.`,
      );
    }
    inputs.push(input);
    place += one.length + 1;
  }
  return inputs;
}

/**
 * Reads a scene, without the # before it; throws a SceneError.
 *
 * @satisfies SWR-SITE-017
 */
export function readScene(text: string, vocabulary: Vocabulary): Scene {
  const found = /^robot=([^&]*)&seed=([^&]*)&inputs=/.exec(text);
  if (found === null) {
    throw new SceneError(0, "a scene is robot=NAME&seed=NUMBER&inputs=INPUTS.");
  }
  const [head, robot = "", digits = ""] = found;
  if (!/^[a-z][a-z0-9_]{0,30}$/.test(robot)) {
    throw new SceneError("robot=".length, `“${robot}” is no name of a robot.`);
  }
  const seed = numberOf(digits, CYCLES);
  if (Number.isNaN(seed)) {
    throw new SceneError(
      `robot=${robot}&seed=`.length,
      `“${digits}” is no number from 0 to ${MOST}.`,
    );
  }
  const inputs = readInputs(text.slice(head.length), head.length, vocabulary);
  return { robot, seed, inputs };
}

/** The text of which readScene() makes the same scene. */
export function writeScene({ robot, seed, inputs }: Scene): string {
  const all = inputs.map(({ cycle, words }) => `${cycle}:${words.join(",")}`);
  return `robot=${robot}&seed=${seed}&inputs=${all.join(";")}`;
}

/** A command of which each word stands at its place; null: the input is an order. */
export function commandOf(
  { words: [kind = "", ...fields] }: Input,
  vocabulary: Vocabulary,
): { kind: number; words: Map<number, number> } | null {
  const code = vocabulary.commands.get(kind);
  if (code === undefined) {
    return null;
  }
  const words = new Map<number, number>();
  for (const field of fields) {
    const [name = "", value = ""] = field.split("=");
    const known = fieldOf(kind, name, vocabulary) ?? "";
    const offset = vocabulary.fields.get(known)?.offset ?? 0;
    valuesOf(known, value, vocabulary)?.forEach((one, at) =>
      words.set(offset + at, one),
    );
  }
  return { kind: code, words };
}
