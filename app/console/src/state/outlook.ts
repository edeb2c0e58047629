// SPDX-License-Identifier: Apache-2.0
// Commands that are allowed now, as the server reports them. A refusal has the same name.
import { Modes, Robot } from "@interface";
import type { Mode, Path, PoseName, Status } from "@interface";
import { useAnswer } from "./answer";
import type { Page } from "./page";

const MODES_PATH: Path = "/api/v1/modes";
export const ASK_AGAIN_MS = 1000;

const ROBOT_PATH: Path = "/api/v1/robot";

/** Null while it is not known. */
export function useOutlook(page: Page, status: Status): Modes | null {
  const { workphase, order, is_registered, has_target, is_homed } = status;
  const cause = [workphase.name, order, is_registered, has_target, is_homed];
  return useAnswer(page, MODES_PATH, Modes, ASK_AGAIN_MS, cause.join())[0];
}

/**
 * Why the mode cannot be armed or the act not be done now; what is not known cannot be.
 *
 * @satisfies SWR-CON-044
 */
export function reasonAgainst(
  outlook: Modes | null,
  name: Mode["name"],
): string | null {
  const all = [...(outlook?.modes ?? []), ...(outlook?.commands ?? [])];
  const found = all.find((one) => one.name === name);
  return found === undefined ? "Not known yet." : found.reason;
}

export type Way = "upwards" | "downwards";

/**
 * Why the mode cannot be armed for this axis that way, where it can be for another; null: it can.
 *
 * @satisfies SWR-MODE-013
 */
export function reasonAgainstAxis(
  outlook: Modes | null,
  mode: Mode["name"],
  axis: string,
  way: Way,
): string | null {
  const found = outlook?.modes
    .find(({ name, is_allowed }) => name === mode && is_allowed)
    ?.axes.find((one) => one.axis === axis);
  return found?.[`${way}_reason`] ?? null;
}

/** The constant data of the robot; null while they are not known. */
export function useRobot(page: Page, bootId: string): Robot | null {
  return useAnswer(page, ROBOT_PATH, Robot, null, bootId)[0];
}

/** Those of the robot's file; none while they are not known. */
export function usePoses(page: Page, bootId: string): readonly PoseName[] {
  return useRobot(page, bootId)?.poses ?? [];
}
