// SPDX-License-Identifier: Apache-2.0
// The hand that does what a scene says to the robot of a module.
import {
  commandOf,
  readVocabulary,
  type Input,
  type Vocabulary,
} from "./scene_text.ts";

/** Exports of a module that takes inputs; site/watch.h, and site/exports.h or site/served/served.h. */
export interface HandModule {
  memory: WebAssembly.Memory;
  text(): number;
  order(): number;
  command(): number;
  words(): number;
  vocabulary(): void;
}

// In the words of a command.
const ID = 0;
const PEER = 2;
const KIND = 3;
/** The peer that commands unless a scene names another: a connection of OpenIGTLink. */
const FIRST_PEER = 1;

type Memory = Pick<HandModule, "memory">;

export function say({ memory }: Memory, place: number, words: string): void {
  const bytes = new TextEncoder().encode(`${words}\0`);
  new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
}

export function read({ memory }: Memory, place: number): string {
  const bytes = new Uint8Array(memory.buffer, place);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}

export class SceneHand {
  readonly vocabulary: Vocabulary;
  /** Commands to the robot since it was started. */
  commands = 0;
  private readonly module: HandModule;

  constructor(module: HandModule) {
    this.module = module;
    module.vocabulary();
    this.vocabulary = readVocabulary(read(module, module.words()));
  }

  /** Does one input before the next cycle; throws when it is refused. The first command has the number 1. */
  act(input: Input): void {
    const command = commandOf(input, this.vocabulary);
    if (command === null) {
      say(this.module, this.module.text(), input.words.join(" "));
      if (!this.module.order()) {
        throw new Error(read(this.module, this.module.text()).trim());
      }
      return;
    }
    const at = this.module.command();
    if (at === 0) {
      throw new Error("This cycle takes no more commands.");
    }
    const words = new Int32Array(this.module.memory.buffer, at);
    this.commands += 1;
    words[ID] = this.commands;
    words[PEER] = FIRST_PEER;
    words[KIND] = command.kind;
    command.words.forEach((value, place) => (words[place] = value));
  }
}
