// SPDX-License-Identifier: Apache-2.0
// Rule under test: a program is written or read before it is sent, refused by its step, and run as it is held.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { useCommanding } from "../../state/operation";
import {
  makeCommander,
  makeOutlook,
  type Commander,
  leave,
} from "../../testing/commander";
import { makeRobot } from "../../testing/robot";
import { Program } from "./Program";

const PATH = "/api/v1/program";
const held = {
  steps: 2,
  checksum: 0xabc,
  done: 1,
  is_dose_reached: false,
  is_treatment_stopped: false,
  unread_inputs: [] as { name: string; text: string }[],
  source: "HTTP",
  dwelt_s: 3.25,
};
const steps = [
  { depth_mm: 12, angle_deg: 90, dwell_s: 30, gate: true },
  { depth_mm: 8, dwell_s: 0, gate: false },
];
let commander: Commander;

function Shown() {
  const { operation, authority } = commander;
  const commanding = useCommanding(operation, authority);
  const robot = makeRobot({ authority });
  const outlook = makeOutlook("PROGRAM");
  return <Program {...{ robot, operation, commanding, outlook }} />;
}

function write(label: string, value: string): void {
  fireEvent.change(screen.getByLabelText(label), { target: { value } });
}

function press(name: string): void {
  fireEvent.click(screen.getByRole("button", { name }));
}

async function take(text: string): Promise<void> {
  fireEvent.change(screen.getByLabelText("Choose a program (JSON)…"), {
    target: { files: [new File([text], "program.json")] },
  });
  await vi.waitFor(() => {
    if (
      screen.queryByRole("alert") === null &&
      screen.queryByDisplayValue("12") === null
    ) {
      throw new Error("not read yet");
    }
  });
}

beforeEach(async () => {
  commander = await makeCommander("OPERATOR");
  commander.answers[PATH] = { body: held };
  render(<Shown />);
  await screen.findByText(/Held: 2 steps/);
});

afterEach(() => leave(commander));

test("SWR-CON-034 steps are written, added, removed and sent", () => {
  press("Add a step");
  press("Remove step 1");
  press("Add a step");
  write("Depth, mm of step 1", "12");
  write("Angle, ° of step 1", "90");
  write("Dwell, s of step 1", "30");
  fireEvent.click(screen.getByLabelText("Gate of step 1"));
  expect(
    screen.getByRole<HTMLButtonElement>("button", { name: "Send and check" })
      .disabled,
  ).toBe(true);
  write("Depth, mm of step 2", "8");
  press("Send and check");
  expect(commander.acts()).toEqual([{ path: PATH, body: { steps } }]);
});

test("SWR-CON-034 a file fills the table, is sent as it is, and shows its progress", async () => {
  await take(JSON.stringify({ steps }));
  press("Send and check");
  expect(commander.acts()[0]?.body).toEqual({ steps });
  await screen.findByText("Checked, and held.");
  expect(screen.getByText("done")).toBeTruthy();
  expect(screen.getByText("dwelt 3.3 s")).toBeTruthy();
});

test("SWR-CON-034 who leaves the panel and comes back finds the program as it was", async () => {
  await take(JSON.stringify({ steps }));
  press("Send and check");
  await screen.findByText("Checked, and held.");
  cleanup();
  render(<Shown />);
  expect(screen.getByDisplayValue("12")).toBeTruthy();
  expect(await screen.findByText("dwelt 3.3 s")).toBeTruthy();
});

test("SWR-CON-034 another's program is not taken for the one that stands here", async () => {
  await take(JSON.stringify({ steps }));
  press("Send and check");
  await screen.findByText("done");
  cleanup();
  commander.answers[PATH] = { body: { ...held, checksum: 0xdef } };
  render(<Shown />);
  await screen.findByText(/checksum 00000def/);
  expect(screen.queryByText("done")).toBeNull();
});

test.each([
  "",
  "{}",
  '{"steps": []}',
  '{"steps": [{"depth_mm": "1"}]}',
  '{"steps": [{"depth": 1, "dwell_s": 1, "gate": false}]}',
])("SWR-CON-034 a file of %j is no program", async (text) => {
  await take(text);
  expect(screen.getByRole("alert").textContent).toBe(
    "program.json is no treatment program.",
  );
});

test("SWR-CON-034 a refusal names the step", async () => {
  await take(JSON.stringify({ steps }));
  commander.answers[PATH] = {
    status: 409,
    body: { code: "PROGRAM_DEPTH", detail: "Deeper.", pointer: "/steps/1" },
  };
  press("Send and check");
  expect((await screen.findByRole("alert")).textContent).toBe(
    "Refused: PROGRAM_DEPTH, step 2. Deeper.",
  );
});

test.each([
  [{}, "The gate says: go on."],
  [{ is_dose_reached: true }, "The gate says: dose reached."],
  [{ is_treatment_stopped: true }, "The gate says: stop."],
  [
    {
      is_treatment_stopped: true,
      unread_inputs: [{ name: "GATE", text: "The gate of the treatment." }],
    },
    "The gate is not read.",
  ],
])("SWR-CON-130 of a gate that is %s it says: %s", async (gate, text) => {
  cleanup();
  commander.answers[PATH] = { body: { ...held, ...gate } };
  render(<Shown />);
  await screen.findByText(text, { exact: false });
});

test("SWR-CON-034 the program that is held is run by its checksum", () => {
  press("Run program");
  expect(commander.acts()).toEqual([
    { path: `${PATH}/run`, body: { id: 1, checksum: 0xabc } },
  ]);
});
