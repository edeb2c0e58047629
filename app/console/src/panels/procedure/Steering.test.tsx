// SPDX-License-Identifier: Apache-2.0
// Rule under test: curvature and direction of a steering are typed in, and shown with what the robot can do.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import type { SteeringMethod, Targeting as TargetingData } from "@interface";
import {
  makeCommander,
  makeOutlook,
  refusedHere,
  type Commander,
} from "../../testing/commander";
import { makeRobot } from "../../testing/robot";
import { Aim } from "./Aim";
import { Targeting } from "./Targeting";

let commander: Commander;
const LABEL = "Curvature per m, and direction in degrees";

function steered(
  name: SteeringMethod,
  given: Partial<TargetingData> = {},
): Partial<TargetingData> {
  return {
    steering_method: { name, text: "" },
    steering_curvature_per_km: name === "NONE" ? 0 : 1200,
    steering_direction_deg: name === "NONE" ? 0 : -90,
    steering_most_per_km: 1282,
    ...given,
  };
}

async function show(
  given: Partial<TargetingData>,
  ...acts: string[]
): Promise<void> {
  commander = await makeCommander("OPERATOR");
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
}

function button(): HTMLButtonElement {
  return screen.getByRole<HTMLButtonElement>("button", { name: "Steer" });
}

function choose(value: SteeringMethod): void {
  fireEvent.change(screen.getByLabelText("Steering"), { target: { value } });
}

function write(value: string): void {
  fireEvent.change(screen.getByLabelText(LABEL), { target: { value } });
}

afterEach(() => {
  commander.operation.session.stop();
  cleanup();
  vi.unstubAllGlobals();
});

test("SWR-STEER-013 method, curvature and direction are sent as they are typed in", async () => {
  await show(steered("NONE"), "STEER");
  choose("BIDIRECTIONAL");
  for (const wrong of ["1.2", "1.283 0", "-0.1 0", "1 361", "one two", ""]) {
    write(wrong);
    expect(button().disabled).toBe(true);
  }
  write("1.2 -45");
  fireEvent.click(button());
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/targeting/steering",
      body: {
        id: 1,
        method: "BIDIRECTIONAL",
        curvature_per_km: 1200,
        direction_deg: -45,
      },
    },
  ]);
});

test("SWR-STEER-013 a needle that is steered no more needs no number", async () => {
  await show(steered("UNIDIRECTIONAL"), "STEER");
  expect(screen.getByLabelText<HTMLInputElement>(LABEL).value).toBe("1.2 -90");
  choose("NONE");
  fireEvent.click(button());
  expect(commander.acts()[0]?.body).toEqual({
    id: 1,
    method: "NONE",
    curvature_per_km: 0,
    direction_deg: 0,
  });
});

test("SWR-STEER-013 how the needle is steered is shown, and while it waits for its rotation", async () => {
  await show(steered("BIDIRECTIONAL"));
  expect(
    screen.getByText(
      "to and fro, 1.20 per m of at most 1.28 per m towards -90°",
    ),
  ).toBeTruthy();
  expect(button().title || document.body.textContent).toContain(refusedHere);
  cleanup();
  await show(steered("UNIDIRECTIONAL", { is_rotation_awaited: true }));
  expect(
    screen.getByText(/^on in one direction, .*waits for its rotation\.$/),
  ).toBeTruthy();
});

test("SWR-STEER-013 none is shown as such, and nothing of a robot whose needle is not steered", async () => {
  await show(steered("NONE"));
  expect(screen.getByText("none, at most 1.28 per m")).toBeTruthy();
  cleanup();
  await show(steered("NONE", { steering_most_per_km: 0 }));
  expect(screen.queryByLabelText("Steering")).toBeNull();
  expect(screen.queryByText("Steering")).toBeNull();
});
