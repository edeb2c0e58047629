// SPDX-License-Identifier: Apache-2.0
// Rule under test: no two states of a lamp differ in colour alone.
import { cleanup, render } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import {
  cardLamp,
  dataLamp,
  lampTables,
  systemLamps,
  type Level,
} from "./lamps";
import { Lamp } from "./parts/Lamp";
import { makeStatus } from "./testing/robot";

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

test("SWR-CON-002 a state that is not known is shown as such", () => {
  const lamps = systemLamps(makeStatus({ pedal: "melted" as "fault" }));
  expect(lamps[0]).toMatchObject({ level: "unknown", word: "MELTED" });
});

test("SWR-CON-002 a lost card names its faults", () => {
  const lamp = cardLamp({
    slot: 3,
    axis: "insertion",
    link: "lost",
    age_cycles: 9,
    frame_errors: 1,
    faults: ["too hot"],
    type: "non_pwm",
    converters: [0, 0, 0, 0],
  });
  expect(lamp).toEqual({
    label: "Card 3, insertion",
    level: "fault",
    word: "LOST",
    detail: "too hot",
  });
});

test("SWR-LINK-009 a card without an axis has its lamp", () => {
  const lamp = cardLamp({
    slot: 3,
    axis: null,
    link: "live",
    age_cycles: 0,
    frame_errors: 0,
    faults: [],
    type: "non_pwm",
    converters: [0, 0, 0, 0],
  });
  expect(lamp).toEqual({
    label: "Card 3, no axis",
    level: "normal",
    word: "LIVE",
  });
});

test("SWR-CON-002 the data lamp shows the age", () => {
  expect(dataLamp("live", 20).detail).toBe("under 0.1 s");
  expect(dataLamp("late", 440)).toMatchObject({
    word: "LATE",
    detail: "0.4 s",
  });
});
