// SPDX-License-Identifier: Apache-2.0
// Rule under test: curvature and direction of a steering are typed in, and shown with what the robot can do.
import { cleanup, fireEvent, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { SteeringMethod, Targeting as TargetingData } from "@interface";
import { leave, refusedHere, type Commander } from "../../testing/commander";
import { orderButton, showTargeting, write } from "../../testing/targeting";

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
    steering_most_per_km: 1253,
    ...given,
  };
}

function button(): HTMLButtonElement {
  return orderButton("Steer");
}

function choose(value: SteeringMethod): void {
  fireEvent.change(screen.getByLabelText("Steering"), { target: { value } });
}

afterEach(() => leave(commander));

test("SWR-STEER-013 method, curvature and direction are sent as they are typed in", async () => {
  commander = await showTargeting(steered("NONE"), "STEER");
  choose("BIDIRECTIONAL");
  for (const wrong of ["1.2", "1.254 0", "-0.1 0", "1 361", "one two", ""]) {
    write(LABEL, wrong);
    expect(button().disabled).toBe(true);
  }
  write(LABEL, "1.2 -45");
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
  commander = await showTargeting(steered("UNIDIRECTIONAL"), "STEER");
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
  commander = await showTargeting(steered("BIDIRECTIONAL"));
  expect(
    screen.getByText(
      "to and fro, 1.20 per m of at most 1.25 per m towards -90°",
    ),
  ).toBeTruthy();
  expect(button().title || document.body.textContent).toContain(refusedHere);
  cleanup();
  commander = await showTargeting(
    steered("UNIDIRECTIONAL", { is_rotation_awaited: true }),
  );
  expect(
    screen.getByText(/^on in one direction, .*waits for its rotation\.$/),
  ).toBeTruthy();
});

test("SWR-STEER-013 none is shown as such, and nothing of a robot whose needle is not steered", async () => {
  commander = await showTargeting(steered("NONE"));
  expect(screen.getByText("none, at most 1.25 per m")).toBeTruthy();
  cleanup();
  commander = await showTargeting(steered("NONE", { steering_most_per_km: 0 }));
  expect(screen.queryByLabelText("Steering")).toBeNull();
  expect(screen.queryByText("Steering")).toBeNull();
});
