// SPDX-License-Identifier: Apache-2.0
// Rule under test: what is aimed at is sent whole, where it is taken, and looked at before.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import type { RobotState, TargetPreview } from "@interface";
import { RETRY_MS } from "../../state/answer";
import {
  makeCommander,
  makeOutlook,
  refusedHere,
  type Commander,
  leave,
} from "../../testing/commander";
import { makeRobot } from "../../testing/robot";
import { orderButton, write } from "../../testing/targeting";
import { Aim } from "./Aim";

let commander: Commander;
const PREVIEW = "/api/v1/targeting/preview";

const acts = {
  CALIBRATION: ["REGISTRATION", "PROBE"],
  TARGETING: ["ENTRY", "TARGET", "PROBE"],
} as const;

async function show(
  workphase: keyof typeof acts,
  change: Partial<RobotState["targeting"]> = {},
): Promise<void> {
  commander = await makeCommander("OPERATOR");
  const robot = makeRobot({
    authority: commander.authority,
    workphase: { name: workphase, text: "" },
  });
  const targeting = { ...robot.targeting, ...change };
  render(
    <Aim
      robot={{ ...robot, targeting }}
      outlook={makeOutlook(...acts[workphase])}
      operation={commander.operation}
    />,
  );
}

afterEach(() => leave(commander));

test("SWR-CON-018 a registration is sent whole, in CALIBRATION", async () => {
  await show("CALIBRATION");
  write("Scanner from z-frame", "1 0 0 5\n0 1 0 −6\n0 0 1 7");
  expect(orderButton("Register").disabled).toBe(true);
  write("Scanner from z-frame", "1 0 0 5\n0 1 0 −6\n0 0 1 7\n0 0 0 1");
  fireEvent.click(screen.getByLabelText("Only its translation"));
  fireEvent.click(orderButton("Register"));
  const matrix = [1, 0, 0, 5, 0, 1, 0, -6, 0, 0, 1, 7, 0, 0, 0, 1];
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/targeting/registration",
      body: { id: 1, matrix, ignore_rotation: true },
    },
  ]);
});

test("SWR-CON-018 no registration is offered that nobody has written", async () => {
  await show("CALIBRATION");
  expect(orderButton("Register").disabled).toBe(true);
  expect(commander.acts()).toEqual([]);
});

test("SWR-CON-018 a probe that was changed elsewhere is shown before it is sent", async () => {
  await show("TARGETING");
  const { operation, authority } = commander;
  const robot = makeRobot({ authority });
  const [length] = robot.targeting.probe;
  cleanup();
  const aim = (one: RobotState) => (
    <Aim robot={one} outlook={makeOutlook()} operation={operation} />
  );
  const shown = render(aim(robot));
  write("Probe needle_tip, 150 to 350 mm", "200");
  const probe = [{ ...length!, length_mm: 260 }];
  const targeting = { ...robot.targeting, probe };
  shown.rerender(aim({ ...robot, targeting }));
  expect(screen.getByDisplayValue("260.000")).toBeTruthy();
});

test("SWR-CON-044 each is offered where the server says it is taken", async () => {
  await show("TARGETING");
  expect(orderButton("Register").disabled).toBe(true);
  expect(screen.getByText(refusedHere)).toBeTruthy();
  cleanup();
  await show("CALIBRATION");
  write("Entry point, scanner", "1 2 3");
  expect(orderButton("Send entry").disabled).toBe(true);
});

test.each([
  ["Entry point, scanner", "Send entry", "entry"],
  ["Target point, scanner", "Send target", "target"],
])("SWR-CON-018 %s is sent as three numbers", async (label, name, path) => {
  await show("TARGETING");
  for (const text of ["1 2", "1 2 3 4", "1 two 3"]) {
    write(label, text);
    expect(orderButton(name).disabled, text).toBe(true);
  }
  write(label, "1.5, -2; 3");
  fireEvent.click(orderButton(name));
  expect(commander.acts().filter((act) => act.path !== PREVIEW)).toEqual([
    {
      path: `/api/v1/targeting/${path}`,
      body: { id: 1, point_mm: [1.5, -2, 3] },
    },
  ]);
});

const root = Math.sqrt(0.5);

test.each([
  [
    "-1 0 0 5\n0 0 −1 180\n0 -1 0 60\n0 0 0 1",
    { matrix: [-1, 0, 0, 5, 0, 0, -1, 180, 0, -1, 0, 60, 0, 0, 0, 1] },
  ],
  [
    `5 180 60\nw=0, x = 0 z=−${root} y=${root}`,
    { pose: { point_mm: [5, 180, 60], w: 0, x: 0, y: root, z: -root } },
  ],
])("SWR-CON-108 a target is sent as a pose: %s", async (text, aim) => {
  await show("TARGETING");
  write("Target point, scanner", text);
  fireEvent.click(orderButton("Send target"));
  expect(commander.acts().at(-1)).toEqual({
    path: "/api/v1/targeting/target",
    body: { id: 1, ...aim },
  });
  await vi.waitFor(() =>
    expect(commander.acts()).toContainEqual({ path: PREVIEW, body: aim }),
  );
});

test.each([
  "5 180 60 w=1 x=0 y=0",
  "5 180 60 0 0 0 1",
  "w=1 x=0 y=0 z=0",
  "1 2 3 w=1 w=1 x=0 y=0",
  "1 2 3 w=a x=0 y=0 z=0",
])("SWR-CON-108 what can be read in two ways is no pose: %s", async (text) => {
  await show("TARGETING");
  write("Target point, scanner", text);
  expect(orderButton("Send target").disabled).toBe(true);
});

test("SWR-CON-018 the lengths of the probe are sent together", async () => {
  await show("TARGETING");
  write("Probe needle_tip, 150 to 350 mm", "long");
  expect(orderButton("Change probe").disabled).toBe(true);
  screen.getByText("Write a number for needle_tip.");
  write("Probe needle_tip, 150 to 350 mm", "260.5");
  fireEvent.click(orderButton("Change probe"));
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/targeting/probe",
      body: {
        id: 1,
        lengths: [{ name: "needle_tip", length_mm: 260.5 }],
      },
    },
  ]);
});

test("SWR-CON-018 a proposed entry is accepted as it is shown", async () => {
  const proposals = {
    ...makeRobot().targeting.proposals,
    entry_mm: [1, 2, 3],
    entry_by: {
      source: "IGTL" as const,
      peer: 21,
      name: "crtk 10.0.0.8:40001",
      age_s: 12,
    },
  };
  await show("TARGETING", { proposals });
  screen.getByText(
    "Proposed entry 1.00, 2.00, 3.00, from crtk 10.0.0.8:40001, 12 s ago",
  );
  fireEvent.click(orderButton("Accept"));
  fireEvent.click(orderButton("Withdraw"));
  expect(commander.acts()).toEqual([
    { path: "/api/v1/targeting/entry", body: { id: 1, point_mm: [1, 2, 3] } },
    {
      path: "/api/v1/targeting/withdraw",
      body: { id: 2, what: "proposed_entry" },
    },
  ]);
});

test("SWR-CON-107 a proposed registration is shown with its rotation and accepted whole", async () => {
  const registration = [0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1];
  const proposals = {
    ...makeRobot().targeting.proposals,
    registration,
    registration_by: {
      source: "IGTL" as const,
      peer: 21,
      name: "crtk 10.0.0.8:40001",
      age_s: 12,
    },
  };
  await show("TARGETING", { proposals });
  expect(orderButton("Accept registration").disabled).toBe(true);
  cleanup();
  await show("CALIBRATION", { proposals });
  const area = screen.getByLabelText<HTMLTextAreaElement>(
    "Proposed registration, from crtk 10.0.0.8:40001, 12 s ago",
  );
  expect(area.value).toBe("0 -1 0 5\n1 0 0 6\n0 0 1 7\n0 0 0 1");
  fireEvent.click(orderButton("Accept registration"));
  fireEvent.click(orderButton("Withdraw registration"));
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/targeting/registration",
      body: { id: 1, matrix: registration },
    },
    {
      path: "/api/v1/targeting/withdraw",
      body: { id: 2, what: "proposed_registration" },
    },
  ]);
});

test("SWR-CON-060 a lost preview of a target is asked for again until it is there", async () => {
  await show("TARGETING");
  const body = { detail: "A target point needs an entry point." };
  let lost = 2;
  vi.stubGlobal("fetch", (path: string) =>
    path === PREVIEW && lost-- > 0
      ? Promise.reject(new Error("lost"))
      : Promise.resolve(new Response(JSON.stringify(body))),
  );
  write("Target point, scanner", "1 2 3");
  const wait = { timeout: 4 * RETRY_MS };
  expect(await screen.findByText(body.detail, {}, wait)).toBeTruthy();
});

const unreachable: TargetPreview = {
  is_reachable: false,
  code: "AXIS_LIMIT",
  message: "An axis would leave its soft limits.",
  axis: "yaw",
  limit: "lower",
  tightest: null,
  reached: null,
  axes: [],
};

test.each([
  [
    { ...unreachable, code: "OK", is_reachable: true, tightest: "pitch" },
    "Reachable; pitch has the least room.",
  ],
  [unreachable, "An axis would leave its soft limits. (yaw, lower limit)"],
  [
    { detail: "A target point needs an entry point." },
    "A target point needs an entry point.",
  ],
])("SWR-CON-018 a target is looked at before: %o", async (body, sentence) => {
  await show("TARGETING");
  commander.answers[PREVIEW] = { body };
  write("Target point, scanner", "1 2 3");
  expect(await screen.findByText(sentence)).toBeTruthy();
});
