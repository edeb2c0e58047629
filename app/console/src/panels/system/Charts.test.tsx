// SPDX-License-Identifier: Apache-2.0
// Rule under test: the drawing of the chosen chart shows which states are active by word, shape and class, and the last
// change that was seen.
import { charts } from "@charts";
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { makeAxis, makeRobot } from "../../testing/robot";
import { Charts } from "./Charts";

afterEach(cleanup);

const head = makeAxis("head", { reference: "approach" });
const feet = makeAxis("feet", { power: "fault", reference: "lost" });

function choose(label: string, value: string): void {
  fireEvent.change(screen.getByLabelText(label, { exact: true }), {
    target: { value },
  });
}

function ids(kind: string): string[] {
  return [...document.querySelectorAll(`.chart .${kind}`)].map(({ id }) => id);
}

test("SWR-CON-031 the state is said, framed and has the word on it", () => {
  render(<Charts robot={makeRobot()} />);
  expect(screen.getByText("◆ start up")).toBeTruthy();
  expect(ids("now")).toEqual(["workphase-start_up"]);
  expect(ids("within")).toEqual(["workphase-phase", "workphase-operable"]);
  expect(screen.getAllByText("NOW")).toHaveLength(1);
  screen.getByRole("img", { name: "Chart workphase, now in start up" });
});

test("SWR-CON-031 an axis is chosen, and each of its regions shown", () => {
  render(<Charts robot={makeRobot({}, [head, feet])} />);
  choose("Chart", "axis");
  expect(ids("now").sort()).toEqual(["axis-approach", "axis-enabled"]);
  choose("Of", "feet");
  expect(ids("now").sort()).toEqual(["axis-fault", "axis-lost"]);
  expect(screen.getAllByText("NOW")).toHaveLength(2);
});

test("SWR-CON-031 the last change is reported and drawn, also when another chart was looked at", () => {
  const { rerender } = render(<Charts robot={makeRobot()} />);
  screen.getByText("No change seen since this view was opened.");
  choose("Chart", "estop_latch");
  rerender(<Charts robot={makeRobot({ estop: "pulled" })} />);
  screen.getByText(/^Last change seen: clear → pulled, [\d:]{8} UTC/);
  screen.getByText("ESTOP-T01, on opened");
  expect(ids("taken")).toContain("ESTOP-T01");
  choose("Chart", "workphase");
  choose("Chart", "estop_latch");
  screen.getByText(/^Last change seen: clear → pulled/);
});

test("SWR-CON-031 the drawing is moved to where the last change has led", () => {
  const { rerender } = render(<Charts robot={makeRobot({}, [head])} />);
  choose("Chart", "axis");
  const frame = screen.getByRole("region", { name: "Drawing" });
  const corner = (id: string) => charts.axis.corners[id]![0] * (14 / 11);
  expect(frame.scrollLeft).toBeCloseTo(corner("axis-approach"));
  const disabled = { ...head, power: "disabled" as const };
  rerender(<Charts robot={makeRobot({}, [disabled])} />);
  expect(frame.scrollLeft).toBeCloseTo(corner("axis-disabled"));
});

test("SWR-CON-031 of a change that several transitions may have made all are reported", () => {
  const { rerender } = render(<Charts robot={makeRobot()} />);
  const workphase = { name: "EMERGENCY" as const, text: "" };
  rerender(<Charts robot={makeRobot({ workphase })} />);
  screen.getByText("By one of these; which, is not reported:");
  screen.getByText("PHASE-T03, on estop");
  expect(screen.getAllByRole("listitem")).toHaveLength(2);
});

test("SWR-CON-031 a change in several steps is reported as such", () => {
  const fresh = makeAxis("head", { reference: "fresh" });
  const { rerender } = render(<Charts robot={makeRobot({}, [fresh])} />);
  choose("Chart", "axis");
  rerender(<Charts robot={makeRobot({}, [makeAxis("head")])} />);
  screen.getByText(/^In several steps/);
  expect(ids("taken")).toEqual([]);
});
