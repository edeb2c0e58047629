// SPDX-License-Identifier: Apache-2.0
// A question "what if": another input at the moment at which time stands still.
import { whatIf, type SceneRun } from "../what_if/scene_run.ts";
import {
  readInput,
  type Input,
  type Vocabulary,
} from "../what_if/scene_text.ts";
import { CYCLES_PER_MS } from "./pace.ts";

export const MOST_SECONDS = 30;
const CYCLES_PER_S = 1000 * CYCLES_PER_MS;

export interface Question {
  /** An order of the box or a command, with spaces. */
  input: string;
  /** For how long both are compared. */
  seconds: number;
}

function everyOne(pattern: string[], axes: string[]): string[] {
  return pattern.reduce<string[]>(
    (begins, words) => {
      const choices =
        words === "SLOT" ? axes : words === "WHO" ? [] : words.split("|");
      return begins.flatMap((begin) =>
        choices.map((word) => `${begin} ${word}`.trim()),
      );
    },
    [""],
  );
}

/** Those that need no number but ones that the module offers. */
export function inputsOf(vocabulary: Vocabulary, axes: string[]): string[] {
  const workphases = [...vocabulary.words.keys()]
    .filter((word) => word.startsWith("WORKPHASE.workphase "))
    .map((word) => word.replace(".", " ").replace(/ (?=[A-Z_]+$)/, "="));
  const orders = vocabulary.orders.flatMap((order) => everyOne(order, axes));
  return [...orders, ...workphases, ...vocabulary.commands.keys()];
}

/** Throws when it is no input. */
export function inputAt(
  cycle: number,
  input: string,
  vocabulary: Vocabulary,
): Input {
  const begin = `${cycle}:`;
  const words = input.trim().replace(/\s+/g, ",");
  return readInput(begin + words, -begin.length, vocabulary);
}

/**
 * The first difference in words, where both runs are the same until now. `inputs` come all the same; throws when one is
 * refused.
 *
 * @satisfies SWR-SITE-033
 */
export function answerOf(
  { input, seconds }: Question,
  inputs: readonly Input[],
  run: SceneRun,
  other: SceneRun,
): string[] {
  const asked = inputAt(run.cycle, input, run.vocabulary);
  const cycles = Math.min(seconds, MOST_SECONDS) * CYCLES_PER_S;
  return whatIf(run, other, inputs, [asked, ...inputs], cycles);
}
