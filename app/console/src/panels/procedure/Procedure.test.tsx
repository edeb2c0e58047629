// SPDX-License-Identifier: Apache-2.0
// Rule under test: the steps that the server allows can be pressed by the page that commands, and no others.
import { fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { Modes, Role, Status } from "@interface";
import {
  makeCommander,
  makeOutlook,
  refusedHere,
  type Commander,
  leave,
} from "../../testing/commander";
import { makeAuthority, makeStatus } from "../../testing/robot";
import { Procedure } from "./Procedure";

let commander: Commander;

async function show(
  outlook: Modes | null,
  change: Partial<Status> = {},
  role: Role = "OPERATOR",
): Promise<void> {
  commander = await makeCommander(role);
  const status = makeStatus({ authority: commander.authority, ...change });
  render(
    <Procedure
      status={status}
      outlook={outlook}
      operation={commander.operation}
    />,
  );
}

function step(name: string): HTMLButtonElement {
  return screen.getByRole<HTMLButtonElement>("button", { name });
}

afterEach(() => leave(commander));

test("SWR-CON-016 a step that is allowed is commanded", async () => {
  await show(makeOutlook("PLANNING"));
  fireEvent.click(step("PLANNING"));
  expect(commander.acts()).toEqual([
    { path: "/api/v1/workphase", body: { id: 1, workphase: "PLANNING" } },
  ]);
});

test("SWR-CON-016 a step that would be refused cannot be pressed, and says why", async () => {
  await show(makeOutlook("PLANNING"));
  expect(step("TARGETING").disabled).toBe(true);
  const says = step("TARGETING").getAttribute("aria-describedby") ?? "";
  expect(document.getElementById(says)?.textContent).toBe(refusedHere);
});

test("SWR-CON-016 the present one is marked, and STOP is no step", async () => {
  await show(makeOutlook("PLANNING"), {
    workphase: { name: "PLANNING", text: "" },
  });
  expect(step("PLANNING").getAttribute("aria-current")).toBe("step");
  expect(step("MANUAL").getAttribute("aria-current")).toBe(null);
  expect(screen.queryByRole("button", { name: "STOP" })).toBe(null);
});

test("SWR-CON-016 without authority no step can be pressed, and it says so once", async () => {
  await show(makeOutlook("PLANNING"), { authority: makeAuthority() });
  expect(step("PLANNING").disabled).toBe(true);
  expect(screen.getAllByText("Take command first.")).toHaveLength(1);
});

test("SWR-CON-016 an observer is asked to log in", async () => {
  await show(makeOutlook("PLANNING"), {}, "OBSERVER");
  expect(step("PLANNING").disabled).toBe(true);
  expect(screen.getByText("Log in as operator to command.")).toBeTruthy();
});

test("SWR-CON-016 what is not known is not offered", async () => {
  await show(null);
  expect(screen.queryByRole("button")).toBe(null);
});

test("SWR-CON-016 a refusal is reported with what is in the way", async () => {
  await show(makeOutlook("PLANNING"));
  commander.answers["/api/v1/workphase"] = {
    status: 409,
    body: { detail: "An axis has a fault.", axis: "yaw", limit: "upper" },
  };
  fireEvent.click(step("PLANNING"));
  const alert = await screen.findByRole("alert");
  expect(alert.textContent).toBe("An axis has a fault. (yaw, upper limit)");
});

test("SWR-CON-016 where positions must be confirmed the button is asked for", async () => {
  const outlook = makeOutlook();
  const [startUp] = outlook.workphases;
  await show({
    ...outlook,
    workphases: [{ ...startUp!, status: "CONFIRM_POSITIONS" }],
  });
  fireEvent.click(step("Confirm the positions shown…"));
  expect(commander.acts()).toEqual([
    { path: "/api/v1/authority/request", body: { id: 1, what: "CONFIRM" } },
  ]);
});

test("SWR-MODE-006 how far it has come is shown while it moves", async () => {
  await show(makeOutlook(), {
    order: "moving",
    done_per_mille: 420,
    left_ms: 3400,
  });
  expect(screen.getByText(/42 % of the axes, 4 s left/)).toBeTruthy();
});
