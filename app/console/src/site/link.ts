// SPDX-License-Identifier: Apache-2.0
// The scene that the link of a page holds, and its refusal.
import { readScene, type Scene, type Vocabulary } from "../what_if/scene_text";
import { askedIn } from "./address";
import type { Order, Report } from "./messages";

type Start = Extract<Order, { kind: "start" }>;

/** The link is to blame, and not the robot. */
export class LinkError extends Error {}

/** Runs `act`; an error that it throws is the link's, and its place is named. */
export function onLink<Result>(act: () => Result, where = ""): Result {
  try {
    return act();
  } catch (failure) {
    throw new LinkError(where + (failure as Error).message);
  }
}

/** Throws a LinkError when the text is no scene. */
export function sceneOf(
  { robot, seed, scene }: Pick<Start, "robot" | "seed" | "scene">,
  vocabulary: Vocabulary,
): Scene {
  return scene === null
    ? { robot, seed, inputs: [] }
    : onLink(() => readScene(askedIn(scene)[0], vocabulary));
}

/** @satisfies SWR-SITE-026 */
export function reportOf(failure: Error): Report {
  const kind = failure instanceof LinkError ? "refused" : "failed";
  return { kind, reason: failure.message };
}
