// SPDX-License-Identifier: Apache-2.0
// Rule under test: a table is seen before it is sent, what is wrong with it is said by name and line, and what is run is what is
// held.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { useCommanding } from "../../state/operation";
import {
  makeCommander,
  makeOutlook,
  type Commander,
  leave,
} from "../../testing/commander";
import { makeRobot } from "../../testing/robot";
import { Trajectory } from "./Trajectory";

const PATH = "/api/v1/trajectory";
const table = "time s,yaw deg,yaw deg/s\n0,0,0\n2.5,-15,1\n";
const none = { rows: 0, checksum: 0, row: 0, source: null, time_s: 0 };
const held = { rows: 2, checksum: 0xabc, row: 1, source: "HTTP", time_s: 1.5 };
let commander: Commander;

function Shown() {
  const { operation, authority } = commander;
  const commanding = useCommanding(operation, authority);
  const robot = makeRobot({ authority });
  const outlook = makeOutlook("TRAJECTORY");
  return <Trajectory {...{ robot, operation, commanding, outlook }} />;
}

async function show(body: object): Promise<void> {
  commander.answers[PATH] = { body };
  render(<Shown />);
  await screen.findByText(/eld/, { selector: "p" });
}

async function take(text: string, isDropped = false): Promise<void> {
  const file = new File([text], "way.csv");
  if (isDropped) {
    const zone = screen.getByText("or drag it here").parentElement;
    fireEvent.drop(zone as HTMLElement, { dataTransfer: { files: [file] } });
  } else {
    fireEvent.change(screen.getByLabelText("Choose a table (CSV)…"), {
      target: { files: [file] },
    });
  }
  await screen.findByText("way.csv");
}

function press(name: string): void {
  fireEvent.click(screen.getByRole("button", { name }));
}

beforeEach(async () => {
  commander = await makeCommander("OPERATOR");
});

afterEach(() => leave(commander));

test.each([false, true])(
  "SWR-CON-034 a table is drawn before it is sent (dragged: %s)",
  async (isDropped) => {
    await show(none);
    await take(table, isDropped);
    expect(screen.getByText(/2 rows, 2\.5 s/)).toBeTruthy();
    const graph = screen.getByRole("img", { name: "Way of yaw over time" });
    expect(graph.querySelector("polyline")?.getAttribute("points")).toBe(
      "0.0,0.0 1000.0,300.0",
    );
    expect(commander.acts()).toEqual([]);
    press("Send and check");
    expect(commander.acts()).toEqual([{ path: PATH, body: { text: table } }]);
    await screen.findByText("Checked, and held.");
  },
);

test("SWR-CON-034 a refusal says its name, its line and what stands there", async () => {
  await show(none);
  await take(table);
  const problem = { code: "AXIS_LIMIT", detail: "Too far.", axis: "yaw" };
  commander.answers[PATH] = {
    status: 409,
    body: { ...problem, limit: "lower", pointer: "line 3" },
  };
  press("Send and check");
  expect((await screen.findByRole("alert")).textContent).toBe(
    "Refused: AXIS_LIMIT, line 3. Too far. (yaw, lower limit) 2.5,-15,1",
  );
});

test("SWR-CON-034 what is run is what is held", async () => {
  await show(held);
  expect(
    screen.getByText(/Held: 2 rows.*checksum 00000abc/).textContent,
  ).toContain("it came to row 2, at 1.5 s");
  press("Run trajectory");
  expect(commander.acts()).toEqual([
    { path: `${PATH}/run`, body: { id: 1, checksum: 0xabc } },
  ]);
});

test("SWR-CON-034 what is held can be deleted", async () => {
  await show(held);
  commander.answers[PATH] = { body: none };
  press("Delete what is held");
  await screen.findByText("No trajectory is held.");
  expect(commander.deletions()).toEqual([PATH]);
});

test("SWR-CON-034 without command nothing is sent, run or deleted", async () => {
  await show(held);
  await take(table);
  cleanup();
  commander.authority = { ...commander.authority, peer: 1 };
  await show(held);
  await take(table);
  for (const name of [
    "Send and check",
    "Run trajectory",
    "Delete what is held",
  ]) {
    expect(
      screen.getByRole<HTMLButtonElement>("button", { name }).disabled,
      name,
    ).toBe(true);
  }
});
