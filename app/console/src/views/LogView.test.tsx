// SPDX-License-Identifier: Apache-2.0
// Rule under test: what has happened is found, followed or stood still at, saved, and added to.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
  within,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Role } from "@interface";
import { makeCommander, type Commander } from "../testing/commander";
import { makeEntry, makeRobot, makeViewProperties } from "../testing/robot";
import { LogView } from "./LogView";

const LOG = "/api/v1/log?limit=200&level=INFORMATION";
const first = makeEntry(0, { severity: "WARNING", text: "It was late." });
let server: Commander;
let refresh: (newest: number) => Promise<void>;

function logOf(...entries: (typeof first)[]) {
  return {
    body: { entries, next: (entries.at(-1)?.number ?? -1) + 1, lost: 0 },
  };
}

/** Reason given by the server. */
const reason = "The role of this account does not allow it.";

async function settle(): Promise<void> {
  await act(() => new Promise((resolve) => setTimeout(resolve, 20)));
}

async function show(role: Role = "ENGINEER"): Promise<void> {
  server = await makeCommander(role);
  Object.assign(server.answers, {
    [LOG]: logOf(first),
    [`${LOG}&after=0`]: logOf(makeEntry(1)),
    "/api/v1/log/level": {
      body: {
        level: "INFORMATION",
        by: null,
        reason: role === "ENGINEER" ? null : reason,
      },
    },
    "/api/v1/logs": {
      body: {
        logs: [
          {
            name: "events-000001.log",
            bytes: 12_345,
            first: "2026-11-22T17:50:00.123Z",
            last: null,
            is_present: true,
          },
        ],
      },
    },
    "/api/v1/recordings": {
      body: {
        recordings: [
          {
            name: "blackbox-000001.bsr",
            bytes: 999,
            started: null,
            robot: "neuro",
            is_present: false,
          },
        ],
      },
    },
  });
  const robot = makeRobot();
  const view = (newest: number) => (
    <LogView
      {...makeViewProperties(server.operation, robot, [makeEntry(newest)])}
    />
  );
  const { rerender } = render(view(0));
  refresh = async (newest) => {
    rerender(view(newest));
    await settle();
  };
  await settle();
}

function events(): (string | null)[] {
  const list = screen.getByRole("region", { name: "Events that fit" });
  return within(list)
    .getAllByRole("row")
    .slice(1)
    .map(({ textContent }) => textContent);
}

async function press(name: string): Promise<void> {
  fireEvent.click(screen.getByRole("button", { name }));
  await settle();
}

beforeEach(() => show());

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

test("SWR-CON-038 an event is reported with both times, severity and sentence", () => {
  expect(events()).toEqual([
    "2026-11-22 17:50:00.123 0.0 swarningIt was late.",
  ]);
});

test("SWR-CON-038 the list follows", async () => {
  await refresh(1);
  expect(events()[0]).toContain("Event 1.");
});

test("SWR-CON-038 the list stands still and counts what has come since", async () => {
  await press("Pause");
  await refresh(1);
  expect(events()).toHaveLength(1);
  expect(screen.getByText("Paused; 1 new since.")).toBeTruthy();
  await press("Follow");
  expect(events()).toHaveLength(2);
});

test("SWR-CON-038 level and text are the server's to search, and those of the file", async () => {
  const found = "level=CRITICAL&text=lost";
  server.answers[`/api/v1/log?limit=200&${found}`] = logOf(makeEntry(5));
  fireEvent.change(screen.getByLabelText("From level"), {
    target: { value: "CRITICAL" },
  });
  fireEvent.change(screen.getByLabelText("With the text"), {
    target: { value: "lost" },
  });
  await screen.findByText("Event 5.");
  expect(events()).toHaveLength(1);
  const link = screen.getByRole("link", { name: /CSV/ });
  expect(link.getAttribute("href")).toBe(`/api/v1/log.csv?${found}`);
});

test("SWR-CON-038 a log that cannot be read is said to be so", async () => {
  server.answers[`${LOG}&after=0`] = { status: 503, body: {} };
  await refresh(1);
  expect(screen.getByText("The log cannot be read now.")).toBeTruthy();
});

test("SWR-CON-038 a note is written, and the field is empty again", async () => {
  const field = screen.getByLabelText<HTMLInputElement>("Note");
  fireEvent.change(field, { target: { value: "Turned by 5°." } });
  expect(screen.getByText("146 bytes left.")).toBeTruthy();
  await press("Write into the log");
  expect(server.acts()).toEqual([
    { path: "/api/v1/log/note", body: { id: 1, text: "Turned by 5°." } },
  ]);
  expect(field.value).toBe("");
});

test("SWR-CON-038 a note that is refused stays, with the server's reason", async () => {
  const detail =
    "A note was written within this second; write this one after it.";
  server.answers["/api/v1/log/note"] = { status: 429, body: { detail } };
  const field = screen.getByLabelText<HTMLInputElement>("Note");
  fireEvent.change(field, { target: { value: "Again." } });
  await press("Write into the log");
  expect(screen.getByRole("alert").textContent).toBe(detail);
  expect(field.value).toBe("Again.");
});

test("SWR-CON-038 a note that is too long is not sent", () => {
  fireEvent.change(screen.getByLabelText("Note"), {
    target: { value: "°".repeat(81) },
  });
  const button = screen.getByRole<HTMLButtonElement>("button", {
    name: "Write into the log",
  });
  expect(button.disabled).toBe(true);
  expect(screen.getByText("-2 bytes left.")).toBeTruthy();
});

test("SWR-CON-038 an engineer sets the level of the file", async () => {
  const label = "The file gets events from level";
  server.answers["/api/v1/log/level"] = {
    body: { level: "WARNING", by: "anna", reason: null },
  };
  fireEvent.change(screen.getByLabelText(label), {
    target: { value: "WARNING" },
  });
  await settle();
  expect(server.puts()).toEqual([
    { path: "/api/v1/log/level", body: { level: "WARNING" } },
  ]);
  expect(screen.getByText("Set by anna.")).toBeTruthy();
});

test("SWR-CON-038 an observer looks, writes nothing and sets nothing", async () => {
  cleanup();
  await show("OBSERVER");
  expect(screen.getByLabelText<HTMLInputElement>("Note").disabled).toBe(true);
  expect(screen.getByText(/Log in as operator to write/)).toBeTruthy();
  expect(screen.getByText(`As at the start. ${reason}`)).toBeTruthy();
  const level = screen.getByLabelText<HTMLSelectElement>(
    "The file gets events from level",
  );
  expect(level.disabled).toBe(true);
});

test("SWR-CON-038 logs and recordings are reported and can be saved", () => {
  const rows = screen.getAllByRole("row", { name: /000001/ });
  expect(rows.map(({ textContent }) => textContent)).toEqual([
    "events-000001.log2026-11-22 17:50:00.123not known12.3 kBbeing writtenSave",
    "blackbox-000001.bsrnot knownneuro999 BclosedSave",
  ]);
  const links = screen.getAllByRole("link", { name: /^Save / });
  expect(links.map((link) => link.getAttribute("href")).slice(-2)).toEqual([
    "/api/v1/logs/events-000001.log",
    "/api/v1/recordings/blackbox-000001.bsr",
  ]);
});
