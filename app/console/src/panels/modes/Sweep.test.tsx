// SPDX-License-Identifier: Apache-2.0
// Rule under test: a sweep is commanded once the axis is said to be free, and its curve is shown with its numbers.
import { fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { LogEntry, Status, Sweep as Kept } from "@interface";
import { useCommanding } from "../../state/operation";
import {
  makeCommander,
  makeOutlook,
  type Commander,
  leave,
} from "../../testing/commander";
import {
  makeAxis,
  makeEntry,
  makeRobot,
  makeStatus,
} from "../../testing/robot";
import { readRuns } from "../../words/sweep_runs";
import { Sweep } from "./Sweep";

const LOG = "/api/v1/log?text=SWEEP_&limit=200";
const kept: Kept = {
  state: "kept",
  axis: "rotation",
  ended: "2026-11-22T17:50:00.123Z",
  end: "POINTS",
  points: [
    {
      frequency_hz: 53000,
      upwards_rpm: 1.5,
      downwards_rpm: 1.25,
      expected_rpm: null,
    },
    {
      frequency_hz: 51000,
      upwards_rpm: 120,
      downwards_rpm: 118.5,
      expected_rpm: 121,
    },
  ],
};
const begun = ["SWEEP_BEGUN", "SWEEP_WORD", "SWEEP_UPWARDS", "SWEEP_WORD"];
const entries = [
  ["SWEEP_WORD", 1],
  ["SWEEP_UPWARDS", 1],
  [begun[0], 0],
  [begun[1], 53000],
  [begun[2], 100],
  ["SWEEP_DOWNWARDS", -90],
  [begun[3], 52000],
].map(([name, value]) =>
  makeEntry(1, {
    name: name as LogEntry["name"],
    value: Number(value),
    text: `${name} ${value}.`,
  }),
);
let commander: Commander;

function Shown({ change }: { change: Partial<Status> }) {
  const { operation, authority } = commander;
  const [card] = makeStatus().cards;
  const cards = [{ ...card, axis: "rotation", type: "high_frequency" }];
  const robot = makeRobot(
    { authority, cards: cards as Status["cards"], ...change },
    [makeAxis("head"), makeAxis("rotation", { unit: "deg" })],
  );
  const commanding = useCommanding(operation, authority);
  const outlook = makeOutlook("SWEEP");
  return <Sweep {...{ robot, operation, commanding, outlook }} />;
}

async function show(body: Kept, change: Partial<Status> = {}): Promise<void> {
  commander = await makeCommander("OPERATOR");
  commander.answers["/api/v1/sweep"] = { body };
  commander.answers[LOG] = { body: { entries, next: 8, lost: 0 } };
  render(<Shown change={change} />);
  await screen.findByRole("heading", { name: "Last sweep that was done" });
}

afterEach(() => leave(commander));

test("SWR-CON-035 a sweep is commanded once its axis is said to be free", async () => {
  await show(kept);
  const order = screen.getByRole<HTMLButtonElement>("button", {
    name: "Sweep rotation",
  });
  expect(order.disabled).toBe(true);
  fireEvent.click(screen.getByRole("checkbox"));
  fireEvent.click(order);
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/motion/sweep",
      body: { id: 1, axis: "rotation", is_free: true },
    },
  ]);
});

test("SWR-CON-035 the curve stands beside what is expected, and its numbers in a table", async () => {
  await show(kept);
  const rows = screen
    .getAllByRole("row")
    .map((row) => [...row.children].map((cell) => cell.textContent));
  expect(rows.slice(1)).toEqual([
    ["51.00 kHz", "120.00", "118.50", "121.00"],
    ["53.00 kHz", "1.50", "1.25", "–"],
  ]);
  expect(document.querySelectorAll(".graph polyline")).toHaveLength(3);
  fireEvent.change(screen.getByLabelText("Cursor"), { target: { value: "1" } });
  expect(
    document.querySelector("tr[aria-current]")?.firstChild?.textContent,
  ).toBe("53.00 kHz");
  const said = "53.00 kHz: upwards 1.50, downwards 1.25, expected – /min";
  expect(screen.getByText(said)).toBeTruthy();
  expect(screen.getByRole("link").getAttribute("href")).toBe(
    "/api/v1/sweep.csv",
  );
});

test.each(["none", "damaged", "other_robot"] as const)(
  "SWR-CON-035 a sweep that is %s is said and not shown",
  async (state) => {
    await show({
      ...kept,
      state,
      axis: null,
      ended: null,
      end: null,
      points: [],
    });
    expect(screen.getByText(/No sweep|damaged|another robot/)).toBeTruthy();
    expect(screen.queryByRole("table")).toBeNull();
    expect(screen.queryByRole("link")).toBeNull();
  },
);

test("SWR-CON-035 a sweep that runs is drawn by what the log says of it", async () => {
  await show(kept, {
    order: "moving",
    mode: { name: "SWEEP", text: "" },
  });
  await screen.findByText("SWEEP_WORD 52000.");
  expect(
    screen.getByRole("img", { name: "Degrees in a run by frequency" }),
  ).toBeTruthy();
  expect(readRuns(entries)).toEqual([
    { hertz: 53000, upwards: 100, downwards: -90 },
  ]);
});

test("SWR-CON-035 a robot without waves has nothing to sweep", async () => {
  await show(kept, { cards: [] });
  expect(screen.queryByRole("checkbox")).toBeNull();
  expect(screen.getByText("No card of this robot makes waves.")).toBeTruthy();
});
