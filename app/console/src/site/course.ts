// SPDX-License-Identifier: Apache-2.0
// Inputs of the robot of a page since its start: with robot and seed all that decides where it is.
import { writeScene, type Input, type Scene } from "../what_if/scene_text.ts";

export const MOST_INPUTS = 10_000;
/** Characters of a link behind the #. Browsers take more, many programs that pass links on do not. */
export const MOST_LINK = 30_000;
/** A handle that is held at the box is renewed more often than it needs: it lets go after 1.5 s (box_grip.h). */
const RENEWED_CYCLES = 1000;

const TOO_MANY = `More than ${MOST_INPUTS.toLocaleString("en")} inputs were given, and are not kept.`;

function isSame(one: Input | undefined, { words }: Input): boolean {
  return one?.words.join(" ") === words.join(" ");
}

/** @satisfies SWR-SITE-030 */
export class Course {
  private kept: Input[] = [];
  /** Why it is not known; null: it is. */
  problem: string | null = null;

  get inputs(): readonly Input[] {
    return this.kept;
  }

  /** Inputs before the next cycle, in this order; null: there were some that are unknown. */
  add(inputs: readonly Input[] | null): void {
    inputs?.forEach((input) => this.keep(input));
    if (inputs === null || this.kept.length > MOST_INPUTS) {
      this.problem = TOO_MANY;
    }
    if (this.problem !== null) {
      this.kept = [];
    }
  }

  /** As a link has it behind the #, with what comes `later`; throws when it is not known or too long. */
  write(
    start: Pick<Scene, "robot" | "seed">,
    later: readonly Input[] = [],
  ): string {
    if (this.problem !== null) {
      throw new Error(this.problem);
    }
    const text = writeScene({
      ...start,
      inputs: [...this.kept, ...later],
    });
    if (text.length > MOST_LINK) {
      const [length, most] = [text.length, MOST_LINK].map((count) =>
        count.toLocaleString("en"),
      );
      throw new Error(
        `The link would have ${length} characters; ${most} is the most.`,
      );
    }
    return text;
  }

  /** A renewal between two others that are near enough changes nothing. */
  private keep(input: Input): void {
    const [before, last] = this.kept.slice(-2);
    const since = (one: Input | undefined) =>
      isSame(one, input) ? input.cycle - (one?.cycle ?? 0) : Infinity;
    if (
      input.words[0] === "keep" &&
      (since(last) === 0 ||
        (isSame(last, input) && since(before) < RENEWED_CYCLES))
    ) {
      this.kept.pop();
    }
    this.kept.push(input);
  }
}
