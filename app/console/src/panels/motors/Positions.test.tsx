// SPDX-License-Identifier: Apache-2.0
// Rule under test: positions are restored after they were shown and a second question, and a refusal has its name.
import {
  cleanup,
  fireEvent,
  render,
  screen,
  within,
} from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import type { PositionsPreview, PreviewAxis } from "@interface";
import { saveText } from "../../words/download";
import { makeCommander, type Commander } from "../../testing/commander";
import { makeAxis, makeRobot } from "../../testing/robot";
import { Positions } from "./Positions";

vi.mock("../../words/download", () => ({ saveText: vi.fn() }));

const PREVIEW = "/api/v1/positions/preview";
const RESTORE = "/api/v1/positions/restore";
const saved = { format: "boresight-positions/1", robot: "neuro" };
let commander: Commander;

function makeRow(name: string, change: Partial<PreviewAxis>): PreviewAxis {
  return {
    name,
    unit: "mm",
    now: 0,
    saved: 12.5,
    delta: 12.5,
    now_ticks: 0,
    saved_ticks: 125,
    is_restored: true,
    grade: "unverified",
    why: "counts_agree",
    ...change,
  };
}

const preview: PositionsPreview = {
  token: 77,
  left_s: 60,
  origin: "sealed",
  saved_utc: "2026-11-22T10:00:00Z",
  is_same_power_on: true,
  axes: [
    makeRow("head", {}),
    makeRow("feet", { is_restored: false, grade: "verified", why: "moved" }),
  ],
};

async function show(): Promise<void> {
  commander = await makeCommander("ENGINEER");
  commander.answers[PREVIEW] = { body: preview };
  const axes = [makeAxis("head", { reference: "lost" }), makeAxis("feet")];
  render(
    <Positions
      robot={makeRobot({ authority: commander.authority }, axes)}
      operation={commander.operation}
    />,
  );
}

function file(content: object | string): File {
  const text = typeof content === "string" ? content : JSON.stringify(content);
  return new File([text], "saved.json");
}

function pick(content: object | string): void {
  fireEvent.change(screen.getByLabelText("Restore from a file…"), {
    target: { files: [file(content)] },
  });
}

function press(name: string): void {
  fireEvent.click(screen.getByRole("button", { name }));
}

afterEach(() => {
  commander.operation.session.stop();
  cleanup();
  vi.unstubAllGlobals();
  vi.mocked(saveText).mockClear();
});

test("SWR-CON-028 saves a file with the name of the robot and the time", async () => {
  await show();
  commander.answers["/api/v1/positions"] = {
    body: { ...saved, saved_utc: "2026-11-22T10:00:00Z" },
  };
  press("Save positions");
  await vi.waitUntil(() => vi.mocked(saveText).mock.calls.length > 0);
  expect(vi.mocked(saveText).mock.calls[0]?.[0]).toBe(
    "positions-neuro-2026-11-22T10-00-00Z.json",
  );
});

test("SWR-CON-028 saves nothing while an axis moves, and says why", async () => {
  await show();
  const detail = "Let it rest first.";
  commander.answers["/api/v1/positions"] = {
    status: 409,
    body: { code: "NOT_AT_REST", detail },
  };
  press("Save positions");
  const alert = await screen.findByRole("alert");
  expect(alert.textContent).toBe(`NOT_AT_REST: ${detail}`);
  expect(saveText).not.toHaveBeenCalled();
});

test("SWR-CON-028 shows what would become of each axis, and changes nothing", async () => {
  await show();
  pick(saved);
  const table = await screen.findByRole("table");
  expect(commander.acts()).toEqual([{ path: PREVIEW, body: { file: saved } }]);
  const cells = within(table)
    .getAllByRole("row")
    .slice(1)
    .map((row) => [...row.children].map(({ textContent }) => textContent));
  expect(cells).toEqual([
    [
      "head",
      "12.50 mm",
      "unknown",
      "unknown",
      "restored",
      "unverified",
      "Its counter stands as it was saved.",
    ],
    [
      "feet",
      "12.50 mm",
      "0.00 mm",
      "12.50 mm",
      "stays",
      "verified",
      "Its counter has moved since. It has not moved",
    ],
  ]);
});

test("SWR-CON-028 a file can be dropped there", async () => {
  await show();
  fireEvent.drop(screen.getByText("or drag it here"), {
    dataTransfer: { files: [file(saved)] },
  });
  await screen.findByRole("table");
});

test("SWR-CON-028 restores what was shown, after a second question", async () => {
  await show();
  pick(saved);
  await screen.findByRole("table");
  press("Apply…");
  expect(document.activeElement?.textContent).toBe("Cancel");
  expect(screen.getByText("Restore head, and forget the target?")).toBeTruthy();
  expect(commander.acts()).toHaveLength(1);
  press("Apply");
  await screen.findByText(/hold the button at the box/);
  expect(commander.acts().at(-1)).toEqual({
    path: RESTORE,
    body: { id: 1, token: 77 },
  });
  expect(screen.queryByRole("table")).toBeNull();
});

test("SWR-CON-028 what control refuses stays to be looked at", async () => {
  await show();
  const detail = "Look again.";
  commander.answers[RESTORE] = { status: 409, body: { detail } };
  pick(saved);
  await screen.findByRole("table");
  press("Apply…");
  press("Apply");
  await screen.findByText(detail);
  expect(screen.getByRole("table")).toBeTruthy();
});

test("SWR-CON-028 leaves it as it is", async () => {
  await show();
  pick(saved);
  await screen.findByRole("table");
  press("Leave as it is");
  expect(screen.queryByRole("table")).toBeNull();
  expect(commander.acts()).toHaveLength(1);
});

test("SWR-CON-028 offers nothing to apply when no axis would be restored", async () => {
  await show();
  const axes = preview.axes.slice(1);
  commander.answers[PREVIEW] = { body: { ...preview, axes } };
  pick(saved);
  await screen.findByText("There is no axis to restore.");
  expect(screen.queryByRole("button", { name: "Apply…" })).toBeNull();
});

test("SWR-CON-105 an axis that has not moved is looked at again, and restored then", async () => {
  await show();
  pick(saved);
  await screen.findByRole("table");
  const [head] = preview.axes;
  const feet = makeRow("feet", { why: "miscounted" });
  const axes = head === undefined ? [feet] : [head, feet];
  commander.answers[PREVIEW] = { body: { ...preview, token: 78, axes } };
  press("It has not moved");
  await screen.findByText(/its counts are wrong/);
  expect(commander.acts().at(-1)).toEqual({
    path: PREVIEW,
    body: { file: saved, miscounted: ["feet"] },
  });
  expect(screen.queryByRole("button", { name: "It has not moved" })).toBeNull();
  press("Apply…");
  expect(screen.getByText(/^Restore head, feet/)).toBeTruthy();
});

test("SWR-CON-028 a list of motors is sent as that of the older program", async () => {
  await show();
  const motors = [{ slot: 1, current_ticks: 5, homed: true }];
  pick(motors);
  await screen.findByRole("table");
  expect(commander.acts()).toEqual([{ path: PREVIEW, body: { motors } }]);
});

test("SWR-CON-028 a file is refused by its name", async () => {
  await show();
  const detail = "The positions are another robot's.";
  commander.answers[PREVIEW] = {
    status: 422,
    body: { code: "SAVED_OTHER_ROBOT", detail },
  };
  pick(saved);
  const alert = await screen.findByRole("alert");
  expect(alert.textContent).toBe(
    `saved.json was refused. SAVED_OTHER_ROBOT: ${detail}`,
  );
});

test("SWR-CON-028 a file that is no JSON is not sent", async () => {
  await show();
  pick("hello");
  await screen.findByText("saved.json was refused. This file is no JSON.");
  expect(commander.acts()).toEqual([]);
});
