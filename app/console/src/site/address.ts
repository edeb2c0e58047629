// SPDX-License-Identifier: Apache-2.0
// Choices in the address of the page after its #: `robot=NAME`, `seed=NUMBER` for its simulated box, and with `inputs=` a
// whole scene (what_if/scene_text.ts), which is played.

import type { Question } from "./question";

/** A question of a link, and the cycle at which it is asked. */
export interface AskedAt extends Question {
  cycle: number;
}

export interface Choice {
  robot: string;
  seed: number;
  /** Text of a scene, as it stands there; null: nothing is played. */
  scene: string | null;
}

const QUESTION = /&at=(\d{1,7})&if=([^&]*)&for=(\d{1,2})$/;
const USUAL = { robot: "neuro", seed: 1 };

/**
 * A choice that is missing there, or is the name of a view, is as usual.
 *
 * @satisfies SWR-SITE-012
 */
export function choiceIn(hash: string): Choice {
  const words = new URLSearchParams(hash.slice(1));
  const seed = words.get("seed") ?? "";
  return {
    robot: words.get("robot") ?? USUAL.robot,
    seed: /^\d{1,9}$/.test(seed) ? Number(seed) : USUAL.seed,
    scene: words.has("inputs") ? hash.slice(1) : null,
  };
}

export function addressOf(robot: string): string {
  return `#robot=${encodeURIComponent(robot)}`;
}

/** The address of the same choice, for any view. */
export function addressIn({ robot, seed, scene }: Choice): string {
  return scene === null ? `${addressOf(robot)}&seed=${seed}` : `#${scene}`;
}

/**
 * Another robot or another scene is another page; what names neither is a view of this one.
 *
 * @satisfies SWR-SITE-028
 */
export function isOther(hash: string, { robot, scene }: Choice): boolean {
  const other = choiceIn(hash);
  const isNamed = new URLSearchParams(hash.slice(1)).has("robot");
  const isScene = other.scene !== null || (isNamed && scene !== null);
  return isScene ? other.scene !== scene : isNamed && other.robot !== robot;
}

/** A scene and what is asked of it, at a cycle of its first 10,000 s; null: nothing is. */
export function askedIn(text: string): [string, AskedAt | null] {
  const found = QUESTION.exec(text);
  const [, cycle, input = "", seconds] = found ?? [];
  const asked = {
    cycle: Math.max(1, Number(cycle)),
    input: input.replaceAll(",", " "),
    seconds: Number(seconds),
  };
  return [text.replace(QUESTION, ""), found === null ? null : asked];
}

/** The whole address of a scene in this page, with a question if there is one. */
export function linkOf(scene: string, asked: AskedAt | null = null): string {
  const words = asked?.input.trim().replace(/\s+/g, ",");
  const question =
    asked === null ? "" : `&at=${asked.cycle}&if=${words}&for=${asked.seconds}`;
  return new URL(`#${scene}${question}`, location.href).href;
}
