// SPDX-License-Identifier: Apache-2.0
// The orders of targeting beside the targeting that the robot reports, on a page that commands.
import { fireEvent, render, screen } from "@testing-library/react";
import type { Targeting as TargetingData } from "@interface";
import { Aim } from "../panels/procedure/Aim";
import { Targeting } from "../panels/procedure/Targeting";
import { makeCommander, makeOutlook, type Commander } from "./commander";
import { makeRobot } from "./robot";

/** With `given` in place of a plain targeting, and these acts allowed. */
export async function showTargeting(
  given: Partial<TargetingData>,
  ...acts: string[]
): Promise<Commander> {
  const commander = await makeCommander("OPERATOR");
  const robot = makeRobot({ authority: commander.authority });
  const targeting = { ...robot.targeting, ...given };
  render(
    <>
      <Targeting targeting={targeting} />
      <Aim
        robot={{ ...robot, targeting }}
        outlook={makeOutlook(...acts)}
        operation={commander.operation}
      />
    </>,
  );
  return commander;
}

export function orderButton(name: string): HTMLButtonElement {
  return screen.getByRole<HTMLButtonElement>("button", { name });
}

export function write(label: string, value: string): void {
  fireEvent.change(screen.getByLabelText(label), { target: { value } });
}
