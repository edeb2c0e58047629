// SPDX-License-Identifier: Apache-2.0
// Rule under test: each mode is listed with what the server says of it, and the chosen one has what commands it.
import { fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { modeButtons, type Modes, type Status } from "@interface";
import {
  makeCommander,
  makeOutlook,
  refusedHere,
  type Commander,
  leave,
} from "../testing/commander";
import { makeRobot } from "../testing/robot";
import { ModesView } from "./ModesView";
import type { ViewProperties } from "./view";

let commander: Commander;

async function show(
  outlook: Modes | null,
  change: Partial<Status> = {},
): Promise<void> {
  commander = await makeCommander("OPERATOR");
  const { answers, authority, operation } = commander;
  answers["/api/v1/robot"] = { body: { poses: ["PARK"], axes: [] } };
  const robot = makeRobot({ authority, ...change });
  const properties = { robot, operation, outlook } as ViewProperties;
  render(<ModesView {...properties} />);
  await screen.findByRole("heading", { name: "Modes" });
}

function choose(name: string): void {
  fireEvent.click(screen.getByRole("radio", { name: new RegExp(`^${name}`) }));
}

afterEach(() => leave(commander));

test("SWR-CON-032 every mode is listed with what the server says of it", async () => {
  const outlook = makeOutlook("RETRACT");
  await show(outlook);
  expect(
    screen.getAllByRole("radio").map((one) => one.parentElement?.textContent),
  ).toEqual(
    outlook.modes.map(({ name }) =>
      name === "RETRACT"
        ? "RETRACT May be commanded."
        : `${name.replaceAll("_", " ")}${name === "HOMING" ? " waiting" : ""} ${refusedHere}`,
    ),
  );
});

test("SWR-CON-032 what the server has not said is not guessed", async () => {
  await show(null);
  expect(
    screen.getByText("The allowed commands are not known yet."),
  ).toBeTruthy();
  expect(screen.queryAllByRole("radio")).toEqual([]);
});

const commanded: [string, string, string, object][] = [
  ["HOMING", "START UP", "/api/v1/workphase", { workphase: "START_UP" }],
  ...Object.entries(modeButtons).map(
    ([mode, { label, path }]) =>
      [mode, label, path, {}] as [string, string, string, object],
  ),
  ["POSE", "Pose PARK", "/api/v1/pose", { pose: "PARK" }],
];

test.each(commanded)(
  "SWR-CON-032 %s is commanded from its panel",
  async (mode, label, path, fields) => {
    await show(makeOutlook(mode));
    choose(mode);
    fireEvent.click(await screen.findByRole("button", { name: label }));
    expect(commander.acts()).toEqual([{ path, body: { id: 1, ...fields } }]);
  },
);

test.each(["JOG", "HOME AXIS"])(
  "SWR-CON-032 %s leads to the motors",
  async (mode) => {
    await show(makeOutlook());
    choose(mode);
    expect(screen.getByRole("link").getAttribute("href")).toBe("#motors");
  },
);

test.each(["VELOCITY", "TRAJECTORY", "SWEEP", "PROGRAM"])(
  "SWR-CON-032 %s has a panel of its own",
  async (mode) => {
    await show(makeOutlook());
    choose(mode);
    expect(screen.getByRole("heading", { name: mode })).toBeTruthy();
    expect(screen.queryByText("Not known yet.")).toBeNull();
  },
);

test("SWR-CON-032 what moves says how far it has come", async () => {
  await show(makeOutlook(), {
    order: "moving",
    mode: { name: "RETRACT", text: "The needle is drawn out." },
    done_per_mille: 420,
    left_ms: 3100,
  });
  expect(
    screen.getByRole("radio", { checked: true }).parentElement?.textContent,
  ).toContain("RETRACT moving");
  expect(
    screen.getByText("42 % of its present leg, 4 s left", { exact: false }),
  ).toBeTruthy();
  expect(
    screen.getByRole("progressbar", { name: "The needle is drawn out." }),
  ).toBeTruthy();
});

const moveArmed = {
  order: "waiting",
  mode: { name: "MOVE", text: "The robot goes to its target." },
} as const;
const stays = /MOVE is armed all the same, and the pedal runs it: command STOP/;

test("SWR-CON-755 a refused insertion by hand says that the move is armed", async () => {
  await show(makeOutlook(), moveArmed);
  choose("COOPERATE");
  const order = screen.getByRole<HTMLButtonElement>("button", {
    name: "Cooperative insertion",
  });
  expect(order.disabled).toBe(true);
  expect(screen.getByText(stays).textContent).toContain(refusedHere);
});

test.each([
  ["that may be commanded", makeOutlook("COOPERATE"), moveArmed],
  ["with nothing armed", makeOutlook(), { ...moveArmed, order: "none" }],
] as const)(
  "SWR-CON-755 an insertion by hand %s says nothing of it",
  async (_, outlook, change) => {
    await show(outlook, change);
    choose("COOPERATE");
    expect(screen.queryByText(stays)).toBeNull();
  },
);
