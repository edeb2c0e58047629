// SPDX-License-Identifier: Apache-2.0
// Rule under test: motions are commanded by the page that has authority, and a position is changed only after a question.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import type { Modes, Role } from "@interface";
import {
  makeCommander,
  makeOutlook,
  refusedHere,
  type Commander,
} from "../testing/commander";
import { makeAxis, makeRobot } from "../testing/robot";
import { Motion } from "./Motion";

let commander: Commander;
const manual = { workphase: { name: "MANUAL", text: "" } } as const;

async function show(
  outlook: Modes,
  role: Role = "ENGINEER",
  change: object = manual,
): Promise<void> {
  commander = await makeCommander(role);
  commander.answers["/api/v1/robot"] = { body: { poses: ["PARK"] } };
  const robot = makeRobot({ authority: commander.authority, ...change }, [
    makeAxis("head"),
    makeAxis("yaw", { unit: "deg", power: "disabled" }),
  ]);
  render(
    <Motion robot={robot} outlook={outlook} operation={commander.operation} />,
  );
  await screen.findByRole("button", { name: "Pose PARK" });
}

function button(name: string): HTMLButtonElement {
  return screen.getByRole<HTMLButtonElement>("button", { name });
}

function press(name: string): void {
  fireEvent.click(button(name));
}

afterEach(() => {
  commander.operation.session.stop();
  cleanup();
  vi.unstubAllGlobals();
});

test("SWR-CON-017 an axis is jogged by the step that was chosen", async () => {
  await show(makeOutlook("JOG"));
  fireEvent.change(screen.getByLabelText("Axis"), { target: { value: "yaw" } });
  fireEvent.change(screen.getByLabelText("Step"), { target: { value: "5" } });
  press("−5.00 °");
  expect(commander.acts()).toEqual([
    { path: "/api/v1/motors/yaw/jog", body: { id: 1, distance: -5 } },
  ]);
});

test("SWR-CON-017 an axis goes to a position that is a number", async () => {
  await show(makeOutlook("JOG"));
  for (const text of ["", "1 2", "x", "1e999"]) {
    fireEvent.change(screen.getByLabelText("Position"), {
      target: { value: text },
    });
    expect(button("Go to").disabled, text).toBe(true);
  }
  fireEvent.change(screen.getByLabelText("Position"), {
    target: { value: "-2.5" },
  });
  press("Go to");
  expect(commander.acts()).toEqual([
    { path: "/api/v1/motors/head/jog", body: { id: 1, position: -2.5 } },
  ]);
});

test.each([
  ["Home head", "HOME_AXIS", "/api/v1/motors/head/home", {}],
  ["Disable head", "", "/api/v1/motors/head/disable", {}],
  ["Retract needle", "RETRACT", "/api/v1/needle/retract", {}],
  ["Align", "ALIGN", "/api/v1/align", {}],
  ["Insert", "INSERT", "/api/v1/needle/insert", {}],
  ["Pose PARK", "POSE", "/api/v1/pose", { pose: "PARK" }],
])("SWR-CON-017 %s is commanded", async (name, mode, path, fields) => {
  await show(makeOutlook(mode));
  press(name);
  expect(commander.acts()).toEqual([{ path, body: { id: 1, ...fields } }]);
});

test("SWR-CON-017 an axis that is disabled can be enabled", async () => {
  await show(makeOutlook());
  fireEvent.change(screen.getByLabelText("Axis"), { target: { value: "yaw" } });
  press("Enable yaw");
  expect(commander.acts()[0]?.path).toBe("/api/v1/motors/yaw/enable");
});

test.each([
  ["Set home", "set-home"],
  ["Clear position", "clear"],
  ["Confirm position", "confirm"],
])("SWR-CON-017 %s asks before it is done", async (name, path) => {
  await show(makeOutlook());
  press(`${name}…`);
  expect(commander.acts()).toEqual([]);
  expect(document.activeElement?.textContent).toBe("Cancel");
  press("Cancel");
  expect(commander.acts()).toEqual([]);
  press(`${name}…`);
  press(name);
  expect(commander.acts()).toEqual([
    { path: `/api/v1/motors/head/${path}`, body: { id: 1 } },
  ]);
});

test("SWR-CON-017 an operator sets no home", async () => {
  await show(makeOutlook("JOG"), "OPERATOR");
  expect(button("Set home…").disabled).toBe(true);
  expect(button("Clear position…").disabled).toBe(true);
  expect(
    screen.getByText("Engineers set home and clear positions."),
  ).toBeTruthy();
});

test("SWR-CON-017 what the server would refuse cannot be pressed, and a group says why once", async () => {
  await show(makeOutlook(), "ENGINEER", {});
  for (const name of ["+1.00 mm", "Go to", "Home head", "Pose PARK", "Align"]) {
    expect(button(name).disabled, name).toBe(true);
  }
  const jog = screen.getByRole("group", { name: "Jog" });
  expect(jog.textContent.split(refusedHere)).toHaveLength(2);
});
