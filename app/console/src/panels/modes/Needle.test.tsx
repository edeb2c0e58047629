// SPDX-License-Identifier: Apache-2.0
// Rule under test: motions of the whole robot are commanded by the page that has authority.
import { fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import {
  makeCommander,
  makeOutlook,
  type Commander,
  leave,
} from "../../testing/commander";
import { makeRobot } from "../../testing/robot";
import { Needle } from "./Needle";

let commander: Commander;

async function show(...allowed: string[]): Promise<void> {
  commander = await makeCommander("OPERATOR");
  commander.answers["/api/v1/robot"] = { body: { poses: ["PARK"] } };
  render(
    <Needle
      robot={makeRobot({ authority: commander.authority })}
      outlook={makeOutlook(...allowed)}
      operation={commander.operation}
    />,
  );
  await screen.findByText("Pose PARK");
}

function button(name: string): HTMLButtonElement {
  return screen.getByText<HTMLButtonElement>(name, { selector: "button" });
}

afterEach(() => leave(commander));

test.each([
  ["Retract needle", "RETRACT", "/api/v1/needle/retract", {}],
  ["Align", "ALIGN", "/api/v1/align", {}],
  ["Insert", "INSERT", "/api/v1/needle/insert", {}],
  ["Pose PARK", "POSE", "/api/v1/pose", { pose: "PARK" }],
])("SWR-CON-017 %s is commanded", async (name, mode, path, fields) => {
  await show(mode);
  fireEvent.click(button(name));
  expect(commander.acts()).toEqual([{ path, body: { id: 1, ...fields } }]);
});

test("SWR-CON-017 a motion that the server would refuse cannot be pressed", async () => {
  await show();
  for (const name of ["Retract needle", "Align", "Insert", "Pose PARK"]) {
    expect(button(name).disabled, name).toBe(true);
  }
});
