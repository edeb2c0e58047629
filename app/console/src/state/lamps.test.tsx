// SPDX-License-Identifier: Apache-2.0
// Rule under test: no two states of a lamp differ in colour alone.
import { cleanup, render } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { Card, Status } from "@interface";
import {
  cardLamp,
  dataLamp,
  lampTables,
  systemLamps,
  type Level,
} from "./lamps";
import { Lamp } from "../parts/drawn/Lamp";
import { makeCard, makeStatus } from "../testing/robot";

const levels: Level[] = ["normal", "active", "attention", "fault", "unknown"];

afterEach(cleanup);

test("SWR-CON-002 each level has a shape of its own", () => {
  const outlines = levels.map((level) => {
    const { container } = render(<Lamp label="a" level={level} word="b" />);
    return container.querySelector("path")?.getAttribute("d");
  });
  expect(new Set(outlines).size).toBe(levels.length);
});

test.each(Object.entries(lampTables))(
  "SWR-CON-002 each state of the lamp %s has a word of its own",
  (_name, table) => {
    const words = Object.values(table).map((state) => state.word);
    expect(new Set(words).size).toBe(words.length);
  },
);

test("SWR-CON-002 a lamp shows its label and its word", () => {
  const { container } = render(
    <Lamp label="E-stop" level="fault" word="PULLED" />,
  );
  expect(container.textContent).toBe("E-stopPULLED");
});

test("SWR-CON-002 a pulled e-stop is a fault and a pressed pedal is not", () => {
  const lamps = systemLamps(makeStatus({ estop: "pulled", pedal: "pressed" }));
  const find = (label: string) => lamps.find((lamp) => lamp.label === label);
  expect(find("E-stop")?.level).toBe("fault");
  expect(find("Pedal")?.level).toBe("active");
});

test("SWR-CON-130 an input that is not read is shown as that and not as what it is taken for", () => {
  const inputs = (["PEDAL", "ESTOP", "SCANNER"] as const).map((name) => ({
    name,
    text: "",
  }));
  const lamps = systemLamps(
    makeStatus({ estop: "pulled", unread_inputs: inputs }),
  );
  expect(lamps.slice(0, 3).map(({ word }) => word)).toEqual([
    "NOT READ",
    "NOT READ",
    "NOT READ",
  ]);
  const one = systemLamps(
    makeStatus({ estop: "pulled", unread_inputs: inputs.slice(2) }),
  );
  expect(one.slice(0, 3).map(({ word }) => word)).toEqual([
    "RELEASED",
    "PULLED",
    "NOT READ",
  ]);
});

test("SWR-CON-002 a state that is not known is shown as such", () => {
  const lamps = systemLamps(makeStatus({ pedal: "melted" as "fault" }));
  expect(lamps[0]).toMatchObject({ level: "unknown", word: "MELTED" });
});

test("SWR-CON-002 a lost card names its faults", () => {
  const lamp = cardLamp(
    makeCard({
      slot: 3,
      axis: "insertion",
      link: "lost",
      faults: ["too hot"],
    }),
  );
  expect(lamp).toEqual({
    label: "Card 3, insertion",
    level: "fault",
    word: "LOST",
    detail: "too hot",
  });
});

test("SWR-LINK-009 a card without an axis has its lamp", () => {
  const lamp = cardLamp(makeCard({ slot: 3, axis: null }));
  expect(lamp).toEqual({
    label: "Card 3, no axis",
    level: "normal",
    word: "LIVE",
  });
});

test("SWR-CON-002 the data lamp shows the age of what is not new", () => {
  expect(dataLamp("live", 20)).toMatchObject({ word: "LIVE" });
  expect(dataLamp("late", 440)).toMatchObject({
    word: "LATE",
    detail: "0.4 s",
  });
});

function lampOf(label: string, change: Partial<Status>) {
  return systemLamps(makeStatus(change)).find((lamp) => lamp.label === label);
}

test.each([
  ["live", "normal", "1 OF 1"],
  ["late", "attention", "0 OF 1"],
  ["lost", "fault", "0 OF 1"],
] as const)("SWR-CON-002 of a card that is %s", (link, level, word) => {
  const cards = makeStatus().cards.map((card) => ({ ...card, link }));
  const other = { ...cards[0], axis: null, slot: 9, link: "lost" } as Card;
  expect(lampOf("Cards", { cards: [...cards, other] })).toMatchObject({
    level,
    word,
  });
});

test.each([
  [100, { level: "normal" }],
  [95, { level: "normal" }],
  [12, { level: "attention", detail: "12\u00a0%" }],
] as const)(
  "SWR-CON-002 states since when, and that time passes at %i %%",
  (speed_percent, expected) => {
    const time = { is_elastic: true, slowness: 8, speedup: 1, speed_percent };
    expect(lampOf("Since start", { cycle: 3_725_500, time })).toEqual({
      label: "Since start",
      word: "1:02:05",
      ...expected,
    });
  },
);

test("SWR-BOX-044 fast time is reported even while it passes no faster", () => {
  const time = {
    is_elastic: true,
    slowness: 1,
    speedup: 10,
    speed_percent: 100,
  };
  expect(lampOf("Since start", { cycle: 0, time })).toMatchObject({
    level: "attention",
    detail: "100\u00a0%",
  });
});

test("SWR-SUP-012 a recorder that runs and records nothing is a fault", () => {
  const { counts, processes } = makeStatus();
  const behind = { counts: { ...counts, unrecorded: 5 } };
  expect(lampOf("Recorder", {})?.word).toBe("RUNNING");
  expect(lampOf("Recorder", behind)).toMatchObject({
    level: "fault",
    word: "BEHIND",
  });
  expect(
    lampOf("Recorder", { ...behind, is_recorder_failing: true }),
  ).toMatchObject({ level: "fault", word: "CANNOT WRITE" });
  expect(
    lampOf("Recorder", {
      ...behind,
      processes: { ...processes, recorder: false },
    })?.word,
  ).toBe("NOT RUNNING");
});

test("SWR-CON-092 the lamp of the recorder says when its disk is full, and warns in time", () => {
  const said = (recording_left_min: number, change: Partial<Status> = {}) =>
    lampOf("Recorder", { ...change, recording_left_min });
  expect(said(0)).toEqual(lampOf("Recorder", {}));
  expect(said(130)).toMatchObject({
    level: "normal",
    word: "RUNNING",
    detail: "disk full in 2 h 10 min at this rate",
  });
  expect(said(30)?.level).toBe("normal");
  expect(said(29)).toMatchObject({
    level: "attention",
    word: "FULL SOON",
    detail: "disk full in 29 min at this rate",
  });
  expect(said(29, { is_recorder_failing: true })?.word).toBe("CANNOT WRITE");
});
