// SPDX-License-Identifier: Apache-2.0
// What may be commanded now, as the server says it. Whoever is refused would be so by the same name.
import { useEffect, useState } from "react";
import type { Modes, Path, PoseName, Robot, Status } from "@interface";
import type { Page } from "./page";

const MODES_PATH: Path = "/api/v1/modes";
export const ASK_AGAIN_MS = 1000;

const ROBOT_PATH: Path = "/api/v1/robot";

/** Null when there is no answer. */
async function ask<Answer>(page: Page, path: Path): Promise<Answer | null> {
  try {
    const response = await page.request("GET", path);
    return response.ok ? ((await response.json()) as Answer) : null;
  } catch {
    return null;
  }
}

/** Null while it is not known. It is asked anew with each change, and every second. */
export function useOutlook(page: Page, status: Status): Modes | null {
  const [modes, setModes] = useState<Modes | null>(null);
  const { workphase, order, is_registered, has_target, is_homed } = status;
  useEffect(() => {
    let isWanted = true;
    const askNow = () =>
      void ask<Modes>(page, MODES_PATH).then(
        (answer) => isWanted && setModes(answer),
      );
    askNow();
    const timer = setInterval(askNow, ASK_AGAIN_MS);
    return () => {
      isWanted = false;
      clearInterval(timer);
    };
  }, [page, workphase.name, order, is_registered, has_target, is_homed]);
  return modes;
}

/** What does not change of the robot; null while it is not known. */
export function useRobot(page: Page, bootId: string): Robot | null {
  const [robot, setRobot] = useState<Robot | null>(null);
  useEffect(() => {
    void ask<Robot>(page, ROBOT_PATH).then(setRobot);
  }, [page, bootId]);
  return robot;
}

/** Those of the robot's file; none while they are not known. */
export function usePoses(page: Page, bootId: string): readonly PoseName[] {
  return useRobot(page, bootId)?.poses ?? [];
}
