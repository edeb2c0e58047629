// SPDX-License-Identifier: Apache-2.0
// Rule under test: every chart is read from the stream by the names that it has for its states, and a change is shown
// with the transitions of the chart that may have made it, and with no others.
import { charts, type ChartName } from "@charts";
import { expect, test } from "vitest";
import { makeAxis, makeRobot } from "../testing/robot";
import {
  causesOf,
  marked,
  observe,
  readers,
  transitionText,
  type Change,
} from "./chart_states";

const at = new Date(0);

function change(from: string, to: string): Change {
  return { from, to, at };
}

test.each(Object.entries(charts))(
  "SWR-CON-031 the states of %s are read by their names",
  (name, { regions }) => {
    const instances = readers[name as ChartName](makeRobot());
    expect(instances).not.toEqual([]);
    for (const { leaves } of instances) {
      expect(Object.keys(leaves)).toEqual(regions.map((region) => region.name));
      for (const region of regions) {
        expect(Object.keys(region.leaves)).toContain(leaves[region.name]);
      }
    }
  },
);

test("SWR-CON-031 what is active around a state is marked with it", () => {
  const reference = charts.axis.regions.find(
    ({ name }) => name === "reference",
  );
  expect(reference?.leaves["approach"]).toEqual([
    "axis-approach",
    "axis-homing",
    "axis-used",
    "axis-reference",
    "axis-axis",
  ]);
});

test("SWR-CON-031 each mark and each corner is in the drawing", () => {
  for (const { drawing, regions, transitions, corners, size } of Object.values(
    charts,
  )) {
    const ids = [
      ...regions.flatMap(({ leaves }) => Object.values(leaves).flat()),
      ...Object.values(transitions).flatMap(({ marks }) => marks),
    ];
    for (const id of ids) {
      expect(drawing).toContain(`<g id="${id}" class="`);
    }
    for (const [x, y] of Object.values(corners)) {
      expect(x).toBeGreaterThanOrEqual(0);
      expect(y).toBeGreaterThanOrEqual(0);
      expect(x).toBeLessThan(size[0]);
      expect(y).toBeLessThan(size[1]);
    }
    expect(drawing).not.toContain("style=");
  }
});

test("SWR-CON-031 a change is reported with its guard", () => {
  const [id, ...others] = causesOf(
    charts.axis,
    "reference",
    change("fresh", "approach"),
  );
  expect(others).toEqual([]);
  expect(transitionText(id!, charts.axis.transitions[id!]!)).toBe(
    "AXIS-T14, on home, if enabled and not switch active",
  );
});

test("SWR-CON-031 what several transitions may have made is reported of all of them", () => {
  expect(
    causesOf(charts.workphase, "state", change("manual", "emergency")),
  ).toEqual(["PHASE-T02", "PHASE-T03"]);
});

test("SWR-CON-031 what no one step makes is reported of none", () => {
  expect(
    causesOf(charts.axis, "reference", change("fresh", "verified")),
  ).toEqual([]);
});

test("SWR-CON-031 a change is kept until the next one, of each axis for itself", () => {
  const [head, feet] = [makeAxis("head"), makeAxis("feet")];
  const pulled = { ...head, power: "disabled" as const };
  const first = observe({}, makeRobot({}, [head, feet]), at);
  const second = observe(first, makeRobot({}, [pulled, feet]), at);
  const third = observe(second, makeRobot({}, [pulled, feet]), new Date(5));
  expect(first["axis/head/power"]?.change).toBeNull();
  expect(second["axis/head/power"]?.change).toEqual(
    change("enabled", "disabled"),
  );
  expect(second["axis/feet/power"]?.change).toBeNull();
  expect(third).toBe(second);
});

test("SWR-CON-031 an element is marked by its whole name", () => {
  const drawing = '<g id="A-10" class="way">\n<g id="A-1" class="way">';
  expect(marked(drawing, { now: ["A-1"] })).toBe(
    '<g id="A-10" class="way">\n<g id="A-1" class="now way">',
  );
});
