// SPDX-License-Identifier: Apache-2.0
// What the address of the page chooses after its #: `robot=NAME`, and `seed=NUMBER` for its simulated box.

export interface Choice {
  robot: string;
  seed: number;
}

const USUAL: Choice = { robot: "neuro", seed: 1 };

/**
 * What is not said there, or is the name of a view, is as usual.
 *
 * @satisfies SWR-SITE-012
 */
export function choiceIn(hash: string): Choice {
  const words = new URLSearchParams(hash.slice(1));
  const seed = words.get("seed") ?? "";
  return {
    robot: words.get("robot") ?? USUAL.robot,
    seed: /^\d{1,9}$/.test(seed) ? Number(seed) : USUAL.seed,
  };
}

export function addressOf(robot: string): string {
  return `#robot=${encodeURIComponent(robot)}`;
}

/** Another robot is another page. */
export function isOther(hash: string, robot: string): boolean {
  const named = new URLSearchParams(hash.slice(1)).get("robot");
  return named !== null && named !== robot;
}
