// SPDX-License-Identifier: Apache-2.0
// A scene as it runs in the module of a robot, and another one beside it that was the same until then.
import { SceneHand, read, say, type HandModule } from "./scene_hand.ts";
import type { Input, Scene, Vocabulary } from "./scene_text.ts";

/** The exports of robot.wasm that are used; site/exports.h and site/watch.h describe them. */
export interface RobotModule extends HandModule {
  start(seed: number): number;
  step(): void;
  outputs(): number;
  outputsSize(): number;
  happened(): void;
  driven(): number;
  look(): number;
  other(): number;
  compareBegin(): void;
  compare(): void;
}

/** Bytes. */
const MEMORY_PAGE = 65_536;

/** All that decides how a run goes on. */
export interface RunState {
  memory: Uint8Array;
  cycle: number;
  commands: number;
}

export class SceneRun {
  /** How many cycles have passed. */
  cycle = 0;
  private readonly module: RobotModule;
  private readonly hand: SceneHand;

  constructor(module: RobotModule) {
    this.module = module;
    this.hand = new SceneHand(module);
  }

  get vocabulary(): Vocabulary {
    return this.hand.vocabulary;
  }

  /** Begins with a robot that was just switched on; throws when there is none such. */
  start({ robot, seed }: Scene): void {
    say(this.module, this.module.text(), robot);
    if (!this.module.start(seed)) {
      throw new Error(`There is no robot ${robot}.`);
    }
    this.cycle = 0;
    this.hand.commands = 0;
  }

  /** Does one input before the next cycle; throws when it is refused. */
  act(input: Input): void {
    this.hand.act(input);
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
    return { memory, cycle: this.cycle, commands: this.hand.commands };
  }

  /** Goes on from a copy, of this or of another run. */
  restore(state: RunState): void {
    const { memory } = this.module;
    const missing = state.memory.length - memory.buffer.byteLength;
    memory.grow(Math.max(0, Math.ceil(missing / MEMORY_PAGE)));
    new Uint8Array(memory.buffer).set(state.memory);
    this.cycle = state.cycle;
    this.hand.commands = state.commands;
  }

  /** Value of "TOPIC FIELD" after the last cycle; null: it does not exist. */
  look(what: string): string | null {
    say(this.module, this.module.words(), what);
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

  /** Values of the last cycle that differ for the first time from those of `other`, in words. */
  compare(other: SceneRun): string[] {
    const { memory, other: place, outputsSize } = this.module;
    new Uint8Array(memory.buffer, place(), outputsSize()).set(other.outputs);
    this.module.compare();
    return this.heard().split("\n").slice(0, -1);
  }

  private heard(): string {
    return read(this.module, this.module.words());
  }
}

/**
 * The effect of `changed` in place of `inputs`: `other` continues from where `run` is, both side by side for at most so
 * many cycles. Returns in words the first cycle in which they differ; none: nothing does.
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
