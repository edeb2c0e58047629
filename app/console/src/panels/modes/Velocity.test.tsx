// SPDX-License-Identifier: Apache-2.0
// Rule under test: speeds are sent as numbers, with a time or the way of one axis, and not before all of it is there.
import { fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import type { RobotAxis } from "@interface";
import { useCommanding } from "../../state/operation";
import {
  makeCommander,
  makeOutlook,
  type Commander,
  leave,
} from "../../testing/commander";
import { makeAxis, makeRobot } from "../../testing/robot";
import { Velocity } from "./Velocity";

const yaw: RobotAxis = {
  name: "yaw",
  unit: "deg",
  slot: 3,
  homing: "switch",
  minimum: -45,
  maximum: 45,
  speed_per_s: 60,
};
let commander: Commander;

function Shown() {
  const { operation, authority } = commander;
  const robot = makeRobot({ authority }, [
    makeAxis("head"),
    makeAxis("yaw", { unit: "deg" }),
  ]);
  const commanding = useCommanding(operation, authority);
  const outlook = makeOutlook("VELOCITY");
  return <Velocity {...{ robot, operation, commanding, outlook }} />;
}

function write(label: string, value: string): void {
  fireEvent.change(screen.getByLabelText(label), { target: { value } });
}

function run(): HTMLButtonElement {
  return screen.getByRole<HTMLButtonElement>("button", {
    name: "Run at speeds",
  });
}

beforeEach(async () => {
  commander = await makeCommander("OPERATOR");
  commander.answers["/api/v1/robot"] = {
    body: { axes: [yaw] },
  };
  render(<Shown />);
  await screen.findByText("at most 60.0 °/s");
});

afterEach(() => leave(commander));

test("SWR-CON-035 axes run at their speeds for a time", () => {
  write("head mm per second", "3");
  write("yaw degrees per second", "-12.5");
  write("of seconds, ramps included", "2");
  fireEvent.click(run());
  const speeds = [
    { axis: "head", speed_per_s: 3, unit: "mm" },
    { axis: "yaw", speed_per_s: -12.5, unit: "deg" },
  ];
  expect(commander.acts()).toEqual([
    { path: "/api/v1/velocity", body: { id: 1, speeds, time_s: 2 } },
  ]);
});

test("SWR-CON-035 one axis runs for a way in its unit", () => {
  write("yaw degrees per second", "10");
  write("For a", "way");
  write("of degrees", "5");
  fireEvent.click(run());
  expect(commander.acts()[0]?.body).toEqual({
    id: 1,
    speeds: [{ axis: "yaw", speed_per_s: 10, unit: "deg" }],
    way: 5,
    unit: "deg",
  });
});

test("SWR-CON-035 nothing is sent before all of it is there", () => {
  const expectMissing = (reason: string) => {
    expect(run().disabled, reason).toBe(true);
    expect(screen.getByText(reason)).toBeTruthy();
  };
  expectMissing("Write the speed of an axis.");
  write("head mm per second", "fast");
  expectMissing("The speed of head is no number.");
  write("head mm per second", "3");
  expectMissing("Write how long or how far.");
  write("of seconds, ramps included", "2");
  expect(run().disabled).toBe(false);
  write("yaw degrees per second", "3");
  write("For a", "way");
  expectMissing("A way is of one axis alone.");
});
