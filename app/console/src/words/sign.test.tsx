// SPDX-License-Identifier: Apache-2.0
// Rule under test: one word says whether the robot moves, may, or why not; banner and title agree.
import { cleanup, render, renderHook } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { Alarm, Axis, Named, PermitReason } from "@interface";
import { SignShape } from "../parts/drawn/SignShape";
import { signOf, type SignKind } from "./sign";
import type { ConsoleView } from "../state/store";
import { makeAxis, makeBlockedAxis, makeRobot } from "../testing/robot";
import { useTitle } from "./title";

const kinds: SignKind[] = [
  "moving",
  "may",
  "armed",
  "stands",
  "estop",
  "lost",
  "fault",
  "stale",
  "absent",
];

function viewOf(...axes: Axis[]): ConsoleView {
  return {
    isConnected: true,
    refusal: null,
    freshness: "live",
    ageMs: 0,
    isOutdated: false,
    robot: makeRobot({}, axes),
    log: [],
  };
}

function because(...names: PermitReason[]): Axis {
  const reasons = names.map((name): Named<PermitReason> => ({
    name,
    text: `It is ${name}.`,
  }));
  return makeBlockedAxis("head", ...reasons);
}

afterEach(cleanup);

test("SWR-CON-020 what is driven moves, whatever else there is", () => {
  const driven = makeAxis("yaw", { is_driven: true });
  expect(signOf(viewOf(because("LINK_LOST"), driven))).toEqual({
    kind: "moving",
    word: "MOVING",
    says: "yaw",
  });
});

test("SWR-CON-020 what is permitted may move, and is named", () => {
  const sign = signOf(viewOf(because("NOTHING_ARMED"), makeAxis("yaw")));
  expect(sign).toMatchObject({ word: "MAY MOVE", says: "yaw" });
});

test("SWR-CON-020 it is armed when an axis misses the pedal alone", () => {
  const others = because("NOTHING_ARMED", "PEDAL_RELEASED");
  expect(signOf(viewOf(others, because("PEDAL_RELEASED")))).toMatchObject({
    word: "ARMED",
    says: "It is PEDAL_RELEASED.",
  });
});

test("SWR-CON-020 it is armed while the hand that is to push has let go", () => {
  const waits = because("PEDAL_RELEASED", "HAND_OFF");
  expect(signOf(viewOf(waits))).toMatchObject({
    word: "ARMED",
    says: "It is PEDAL_RELEASED.",
  });
  expect(signOf(viewOf(because("HAND_OFF")))).toMatchObject({
    word: "ARMED",
    says: "It is HAND_OFF.",
  });
});

test.each([
  [["PEDAL_RELEASED", "NOTHING_ARMED"], "STANDS", "NOTHING_ARMED"],
  [["PEDAL_UNPROVEN", "PEDAL_RELEASED"], "STANDS", "PEDAL_UNPROVEN"],
  [["ESTOP_PULLED", "LINK_LOST"], "E-STOP", "ESTOP_PULLED"],
  [["AXIS_FAULT", "LINK_LOST"], "CARD LOST", "LINK_LOST"],
  [["LINK_LOST", "INPUTS_UNREAD"], "FAULT", "INPUTS_UNREAD"],
  [["NOTHING_ARMED", "AXIS_FAULT"], "FAULT", "AXIS_FAULT"],
  [["ESTOP_PULLED", "MEMORY"], "FAULT", "MEMORY"],
] as const)(
  "SWR-CON-020 of %s it says %s, by the most pressing",
  (names, word, cause) => {
    expect(signOf(viewOf(because(...names)))).toMatchObject({
      word,
      says: `It is ${cause}.`,
    });
  },
);

test("SWR-CON-020 a card that one axis has lost is seen while the others stand", () => {
  const view = viewOf(because("NOTHING_ARMED"), because("LINK_LOST"));
  expect(signOf(view).word).toBe("CARD LOST");
});

function alarmOf(reason: PermitReason, is_over: boolean): Alarm {
  return {
    event: "CARD_LOST",
    reason,
    axis: null,
    is_over,
    subject: "",
    text: "",
    since: null,
    age_s: null,
  };
}

test.each([
  [[alarmOf("LINK_LOST", true)], "STANDS"],
  [[alarmOf("LINK_LOST", true), alarmOf("LINK_LOST", false)], "CARD LOST"],
  [[alarmOf("LINK_LOST", false), alarmOf("ESTOP_LATCHED", true)], "CARD LOST"],
] as const)("SWR-CON-150 of %j it says %s", (alarms, word) => {
  const robot = makeRobot({ alarms: [...alarms] }, [because("LINK_LOST")]);
  expect(signOf({ ...viewOf(), robot })).toMatchObject({
    word,
    says: "It is LINK_LOST.",
  });
});

test("SWR-CON-020 old data never says that it moves or stands", () => {
  const view = viewOf(makeAxis("head", { is_driven: true }));
  expect(signOf({ ...view, freshness: "stale" }).word).toBe("DATA STALE");
  expect(signOf({ ...view, robot: null }).word).toBe("NO DATA");
});

test("SWR-CON-020 each sign has an outline of its own", () => {
  const outlines = kinds.map((kind) => {
    const { container } = render(<SignShape kind={kind} />);
    return container.querySelector("path")?.getAttribute("d");
  });
  expect(new Set(outlines).size).toBe(kinds.length);
});

test("SWR-CON-020 the title of the tab says the word", () => {
  const { rerender } = renderHook((view: ConsoleView) => useTitle(view), {
    initialProps: viewOf(makeAxis("head", { is_driven: true })),
  });
  expect(document.title).toBe("MOVING – Boresight");
  rerender(viewOf(because("ESTOP_PULLED")));
  expect(document.title).toBe("E-STOP – Boresight");
});
