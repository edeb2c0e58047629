// SPDX-License-Identifier: Apache-2.0
// A scene as it runs in the module of a robot, and another one beside it that was the same until then.
import {
  commandOf,
  readVocabulary,
  type Input,
  type Scene,
  type Vocabulary,
} from "./scene_text.ts";

/** What is used of robot.wasm; site/exports.h and site/watch.h say what it is. */
export interface RobotModule {
  memory: WebAssembly.Memory;
  text(): number;
  start(seed: number): number;
  order(): number;
  command(): number;
  step(): void;
  outputs(): number;
  outputsSize(): number;
  words(): number;
  vocabulary(): void;
  happened(): void;
  driven(): number;
  look(): number;
  other(): number;
  compareBegin(): void;
  compare(): void;
}

/** All that decides how a run goes on. */
export interface RunState {
  memory: Uint8Array;
  cycle: number;
  commands: number;
}

// In the words of a command.
const ID = 0;
const PEER = 2;
const KIND = 3;
/** Who commands unless a scene says otherwise: a connection of OpenIGTLink. */
const FIRST_PEER = 1;

export class SceneRun {
  readonly vocabulary: Vocabulary;
  /** How many cycles have passed. */
  cycle = 0;
  private readonly module: RobotModule;
  private commands = 0;

  constructor(module: RobotModule) {
    this.module = module;
    module.vocabulary();
    this.vocabulary = readVocabulary(this.heard());
  }

  /** Begins with a robot that was just switched on; throws when there is none such. */
  start({ robot, seed }: Scene): void {
    this.say(this.module.text(), robot);
    if (!this.module.start(seed)) {
      throw new Error(`There is no robot ${robot}.`);
    }
    this.cycle = 0;
    this.commands = 0;
  }

  /** Does one input before the next cycle; throws when the box refuses it. The first command has the number 1. */
  act(input: Input): void {
    const command = commandOf(input, this.vocabulary);
    if (command === null) {
      this.say(this.module.text(), input.words.join(" "));
      if (!this.module.order()) {
        throw new Error(this.read(this.module.text()).trim());
      }
      return;
    }
    const at = this.module.command();
    if (at === 0) {
      throw new Error(`Cycle ${this.cycle} takes no more commands.`);
    }
    const words = new Int32Array(this.module.memory.buffer, at);
    this.commands += 1;
    words[ID] = this.commands;
    words[PEER] = FIRST_PEER;
    words[KIND] = command.kind;
    command.words.forEach((value, place) => (words[place] = value));
  }

  step(): void {
    this.module.step();
    this.cycle += 1;
  }

  /** Lets the cycles before `cycle` pass, with those of `inputs` that are due. */
  goTo(cycle: number, inputs: readonly Input[]): void {
    while (this.cycle < cycle) {
      inputs
        .filter((input) => input.cycle === this.cycle)
        .forEach((input) => this.act(input));
      this.step();
    }
  }

  /** A copy of the robot as it is. */
  keep(): RunState {
    const memory = new Uint8Array(this.module.memory.buffer).slice();
    return { memory, cycle: this.cycle, commands: this.commands };
  }

  /** Goes on from a copy, of this or of another run. */
  restore(state: RunState): void {
    new Uint8Array(this.module.memory.buffer).set(state.memory);
    this.cycle = state.cycle;
    this.commands = state.commands;
  }

  /** What "TOPIC FIELD" is after the last cycle; null: there is none such. */
  look(what: string): string | null {
    this.say(this.module.words(), what);
    return this.module.look() ? this.heard() : null;
  }

  /** The events and answers of the last cycle, as site/watch.h has them. */
  happened(): string[] {
    this.module.happened();
    return this.heard().split("\n").slice(0, -1);
  }

  get isDriven(): boolean {
    return this.module.driven() !== 0;
  }

  get outputs(): Uint8Array {
    const { memory, outputs, outputsSize } = this.module;
    return new Uint8Array(memory.buffer, outputs(), outputsSize());
  }

  compareBegin(): void {
    this.module.compareBegin();
  }

  /** What in the last cycle is for the first time other than in `other`, in words. */
  compare(other: SceneRun): string[] {
    const { memory, other: place, outputsSize } = this.module;
    new Uint8Array(memory.buffer, place(), outputsSize()).set(other.outputs);
    this.module.compare();
    return this.heard().split("\n").slice(0, -1);
  }

  private say(place: number, words: string): void {
    const bytes = new TextEncoder().encode(`${words}\0`);
    new Uint8Array(this.module.memory.buffer, place, bytes.length).set(bytes);
  }

  private read(place: number): string {
    const bytes = new Uint8Array(this.module.memory.buffer, place);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  private heard(): string {
    return this.read(this.module.words());
  }
}

/**
 * What would be if `changed` were done now instead of `inputs`: `other` goes on from where `run` is, both side by side for
 * at most so many cycles. Returns in words the first cycle in which they differ; none: nothing does.
 *
 * @satisfies SWR-SITE-018
 */
export function whatIf(
  run: SceneRun,
  other: SceneRun,
  inputs: readonly Input[],
  changed: readonly Input[],
  cycles: number,
): string[] {
  const end = run.cycle + cycles;
  other.restore(run.keep());
  other.compareBegin();
  while (run.cycle < end) {
    run.goTo(run.cycle + 1, inputs);
    other.goTo(other.cycle + 1, changed);
    const lines = other.compare(run);
    if (lines.length > 0) {
      return lines;
    }
  }
  return [];
}
