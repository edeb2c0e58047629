// SPDX-License-Identifier: Apache-2.0
// Rule under test: a recording is shown at the cycle that was chosen, and says how far it is to be trusted.
import {
  cleanup,
  fireEvent,
  render,
  screen,
  within,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { makeDocument, released, reported } from "../testing/recording";
import { makeAxis } from "../testing/robot";
import { Recording, type RecordingDocument } from "./recording";
import { Replay } from "./Replay";

vi.mock("../panels/motors/Plots", () => ({
  Plots: ({ trace }: { trace: { length: number } }) => (
    <p>{trace.length} rows are drawn.</p>
  ),
}));

vi.mock("../panels/system/Charts", () => ({
  SeenCharts: ({ seen }: { seen: Record<string, { change: unknown }> }) => (
    <p>{Object.keys(seen).length} states are known.</p>
  ),
}));

beforeEach(() => {
  vi.stubGlobal("matchMedia", () => ({ matches: false }));
});

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

function show(change: Partial<RecordingDocument["recording"]> = {}) {
  render(<Replay recording={new Recording(makeDocument(change))} />);
}

function now(): string {
  return document.querySelector(".replay-now")?.textContent ?? "";
}

function press(name: string): void {
  fireEvent.click(screen.getByRole("button", { name }));
}

test("SWR-REPLAY-018 steps go to events and cycles, and no further than it goes", () => {
  show();
  expect(now()).toMatch(/^cycle 100, .*ARMED: The pedal is released\.$/);
  press("Next event");
  expect(now()).toMatch(/^cycle 150, 0\.05 s, START UP, MOVING$/);
  expect(screen.getByRole("cell", { name: "PWM" })).toBeTruthy();
  press("Back 1 cycle");
  expect(now()).toMatch(/^cycle 149, 0\.05 s, .*ARMED/);
  expect(screen.getByRole("cell", { name: "OFF" })).toBeTruthy();
  press("On 1 s");
  expect(now()).toMatch(/^cycle 200, /);
  expect(screen.getByText("3 rows are drawn.")).toBeTruthy();
  expect(screen.getByText(/^[1-9]\d* states are known\.$/)).toBeTruthy();
  press("Go to cycle 150: It begins.");
  expect(now()).toMatch(/^cycle 150, /);
  expect(screen.getByText("2 rows are drawn.")).toBeTruthy();
});

test("SWR-REPLAY-018 the timeline has workphases, motion, reasons and events, and is moved by keys", () => {
  show();
  const kinds = (lane: string, name: string) =>
    [...document.querySelectorAll(`[data-lane="${lane}"] path`)].map((path) =>
      path.getAttribute(name),
    );
  expect(kinds("workphases", "data-kind")).toEqual(["START_UP"]);
  expect(kinds("signs", "data-kind")).toEqual(["armed", "moving"]);
  expect(kinds("reasons", "data-kind")).toEqual([released.text]);
  expect(kinds("events", "data-severity")).toHaveLength(2);
  const motion = document.querySelector('[data-kind="armed"]');
  expect(motion?.getAttribute("d")).toMatch(/^M0\.0 0V20H500\.0V0z/);
  const slider = screen.getByRole("slider", { name: "Cycle" });
  fireEvent.change(slider, { target: { value: "151" } });
  expect(now()).toMatch(/^cycle 151, .*MOVING$/);
  expect(slider.getAttribute("aria-valuetext")).toBe(now());
});

test("SWR-REPLAY-021 in a gap nothing is known, and nothing is drawn over it", () => {
  const head = makeAxis("head", {});
  const written = makeDocument();
  const recording = new Recording({
    ...written,
    robot: { ...written.robot, axes: [{ ...head, slot: 1 }] as never },
    rows: [
      [100, 0, reported(0, false, "OFF")],
      [20, 0, null],
      [20, 0, reported(0.04, true, "PWM")],
      [50, 0, reported(0.09, false, "OFF")],
    ],
  });
  render(<Replay recording={recording} />);
  expect(screen.getByText(/numbers are reported each 50 cycles/)).toBeTruthy();
  const slider = screen.getByRole("slider", { name: "Cycle" });
  const goTo = (cycle: number) =>
    fireEvent.change(slider, { target: { value: String(cycle) } });
  goTo(119);
  expect(now()).toMatch(/^cycle 119, .*ARMED/);
  goTo(120);
  expect(now()).toBe("cycle 120, not known");
  expect(slider.getAttribute("aria-valuetext")).toBe("cycle 120, not known");
  expect(
    screen.getByText(/^Not known: the recording has nothing/),
  ).toBeTruthy();
  expect(screen.queryByText(/ARMED|MOVING/)).toBeNull();
  expect(screen.queryByRole("cell", { name: "OFF" })).toBeNull();
  goTo(139);
  expect(now()).toBe("cycle 139, not known");
  goTo(140);
  expect(now()).toMatch(/^cycle 140, 0\.04 s, START UP, MOVING$/);
  const lanes = ["workphases", "signs", "reasons"];
  const gaps = lanes.map((lane) =>
    document
      .querySelector(`[data-lane="${lane}"] [data-kind="unknown"]`)
      ?.getAttribute("d"),
  );
  expect(gaps).toEqual(lanes.map(() => "M222.2 0V20H444.4V0z"));
  expect(document.querySelectorAll(".timeline polyline")).toHaveLength(2);
});

test("SWR-REPLAY-021 a recording of which nothing is known is empty", () => {
  const { isEmpty, last } = new Recording({
    ...makeDocument(),
    rows: [[100], [900]],
  });
  expect([isEmpty, last]).toEqual([true, 1000]);
});

test("SWR-REPLAY-018 a text of the recording is shown as it is", () => {
  show();
  const events = screen.getByRole("region", { name: "All events" });
  expect(within(events).getByText("</script> released.")).toBeTruthy();
});

test("SWR-REPLAY-017 it says whether every output was equal, and what is missing", () => {
  show();
  expect(
    screen.getByText(
      "Bit-exact: 201 of 201 cycles replayed, every output equal.",
    ),
  ).toBeTruthy();
  expect(screen.getByText("20261122T174959.123456Z, 0 to 200")).toBeTruthy();
  cleanup();
  show({
    first: 100,
    replayed: 90,
    missing: 11,
    has_run_end: false,
    is_whole_run: false,
  });
  expect(
    screen.getByText(
      "Bit-exact as far as it goes: 90 of at least 201 cycles replayed, their outputs equal; this is not the whole run.",
    ),
  ).toBeTruthy();
  expect(
    screen.getByText(
      "cycles 0 to 99 of the run; 11 cycles in between; the end of the run",
    ),
  ).toBeTruthy();
  cleanup();
  show({ difference: "Cycle 7 differs.", cycles_lost: 3, is_cut_short: true });
  expect(screen.getByText(/^NOT EXACT\. Cycle 7 differs\./)).toBeTruthy();
  expect(
    screen.getByText(
      "the recording is cut short; 3 cycles before it were lost",
    ),
  ).toBeTruthy();
  cleanup();
  show({ is_trusted: false });
  expect(screen.getByText(/^NOT TRUSTED\./)).toBeTruthy();
});

test("SWR-REPLAY-018 another format is not read as this one", () => {
  expect(() => new Recording({ ...makeDocument(), format: 3 })).toThrow(
    "format 3",
  );
});
