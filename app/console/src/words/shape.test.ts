// SPDX-License-Identifier: Apache-2.0
// Rule under test: a message that lacks a member, or holds one of another type, is used for nothing, and the place is said.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Problem, Robot, RobotState, Sweep, type Kind } from "@interface";
import { ask, change } from "../state/answer";
import { Page } from "../state/page";
import { misfitOf } from "./shape";
import { TelemetryStore } from "../state/store";
import { plainRobot } from "../testing/commander";
import { makeRobot } from "../testing/robot";
import { FakeSurroundings } from "../testing/surroundings";

/** Places of all members, of the first of each list. */
function placesIn(value: unknown, place = ""): string[] {
  if (typeof value !== "object" || value === null) {
    return [];
  }
  return Object.entries(value).flatMap(([name, inside]) =>
    Array.isArray(value) && name !== "0"
      ? []
      : [`${place}/${name}`, ...placesIn(inside, `${place}/${name}`)],
  );
}

/** A copy in which `alter` has had its way with the one that holds the place. */
function altered(
  place: string,
  alter: (holder: Record<string, unknown>, name: string) => void,
): RobotState {
  const names = place.slice(1).split("/");
  const copy = structuredClone(robot);
  const holder = names
    .slice(0, -1)
    .reduce(
      (at, name) => at[name] as Record<string, unknown>,
      copy as unknown as Record<string, unknown>,
    );
  alter(holder, names.at(-1) ?? "");
  return copy;
}

function alteredTo(place: string, value: unknown): RobotState {
  return altered(place, (holder, name) => {
    holder[name] = value;
  });
}

const robot = makeRobot();
const places = placesIn(robot);
const members = places.filter((place) => !/\/\d+$/.test(place));
let surroundings: FakeSurroundings;
let store: TelemetryStore;

beforeEach(() => {
  surroundings = new FakeSurroundings();
  store = new TelemetryStore(surroundings);
  store.start();
});

afterEach(() => {
  store.stop();
  vi.unstubAllGlobals();
});

test("SWR-CON-039 a state as it must be fits", () => {
  expect(places.length).toBeGreaterThan(120);
  expect(misfitOf(robot, RobotState)).toBeNull();
});

test("SWR-CON-039 a state without any of its members does not fit", () => {
  const unnoticed = members.filter((place) => {
    const state = altered(place, (holder, name) => delete holder[name]);
    return misfitOf(state, RobotState) !== place;
  });
  expect(unnoticed).toEqual([]);
});

test("SWR-CON-039 a state with another type at any place does not fit", () => {
  const unnoticed = places.filter((place) => {
    const state = altered(place, (holder, name) => {
      holder[name] = typeof holder[name] === "boolean" ? 1 : true;
    });
    return misfitOf(state, RobotState) !== place;
  });
  expect(unnoticed).toEqual([]);
});

test.each([
  ["/status/box", null],
  ["/status/cycle", "/status/cycle"],
  ["/status/mode", "/status/mode"],
  ["/targeting/registration", null],
  ["/motors/axes", "/motors/axes"],
])("SWR-CON-039 null is only where it may be: %s", (place, misfit) => {
  const state = altered(place, (holder, name) => {
    holder[name] = null;
  });
  expect(misfitOf(state, RobotState)).toBe(misfit);
});

test("SWR-CON-039 a word that is not known does not fit", () => {
  const state = altered("/status/estop", (holder, name) => {
    holder[name] = "bent";
  });
  expect(misfitOf(state, RobotState)).toBe("/status/estop");
});

test("SWR-CON-039 a matrix of fifteen numbers does not fit", () => {
  const state = altered("/targeting/zframe_treatment", (holder, name) => {
    (holder[name] as number[]).pop();
  });
  expect(misfitOf(state, RobotState)).toBe("/targeting/zframe_treatment");
});

test("SWR-CON-045 a number that is not finite does not fit", () => {
  const isNumber = (place: string) =>
    misfitOf(alteredTo(place, true), RobotState) === place &&
    misfitOf(alteredTo(place, 1), RobotState) === null;
  const numbers = places.filter(isNumber);
  expect(numbers.length).toBeGreaterThan(40);
  const unnoticed = numbers.filter(
    (place) => misfitOf(alteredTo(place, Infinity), RobotState) !== place,
  );
  expect(unnoticed).toEqual([]);
});

test.each([
  ["/status/cycle", -1],
  ["/status/cycle", 0.5],
  ["/status/cycle", 2 ** 32],
  ["/motors/axes/0/position_ticks", 2 ** 31],
  ["/motors/axes/0/position_ticks", -(2 ** 31) - 1],
  ["/status/cards/0/slot", 10],
])("SWR-CON-045 %s is not %d", (place, value) => {
  expect(misfitOf(alteredTo(place, value), RobotState)).toBe(place);
});

test.each([-1, 0.5, 11, 4294967295])(
  "SWR-CON-045 a robot has no %d slots",
  (slots) => {
    expect(misfitOf(plainRobot, Robot)).toBeNull();
    expect(misfitOf({ ...plainRobot, slots }, Robot)).toBe("/slots");
  },
);

test("SWR-CON-039 members that are not known harm nobody", () => {
  const state = altered("/status/box", (holder) => {
    holder.colour = "grey";
  });
  expect(misfitOf(state, RobotState)).toBeNull();
});

test("SWR-CON-039 what may be missing is checked where it is there", () => {
  const kind: Kind = Problem;
  const problem = {
    type: "about:blank",
    title: "Conflict",
    status: 409,
    detail: "No.",
    code: "BUSY",
  };
  expect(misfitOf(problem, kind)).toBeNull();
  expect(misfitOf({ ...problem, limit: "upper" }, kind)).toBeNull();
  expect(misfitOf({ ...problem, limit: "side" }, kind)).toBe("/limit");
});

test("SWR-CON-039 a state that does not fit changes nothing but the call to load again", () => {
  surroundings.stream.send("state", robot);
  const state = altered("/motors/axes/0/unit", (holder, name) => {
    holder[name] = "inch";
  });
  surroundings.stream.send("state", state);
  expect(store.getView()).toMatchObject({
    isOutdated: true,
    misfit: "state/motors/axes/0/unit",
    robot,
  });
});

test("SWR-CON-039 the call to load again stays when the stream greets", () => {
  surroundings.stream.send("hello", { boot_id: "1" } as never);
  surroundings.stream.send("hello", { boot_id: "1", build_id: "a" });
  expect(store.getView()).toMatchObject({
    isOutdated: true,
    misfit: "hello/build_id",
  });
});

test("SWR-CON-039 an answer that does not fit is none, and is reported", async () => {
  vi.stubGlobal("fetch", () =>
    Promise.resolve(new Response(JSON.stringify({ state: "kept" }))),
  );
  const page = new Page(() => null);
  expect(await ask(page, "/api/v1/sweep", Sweep)).toBeNull();
  expect(store.getView().misfit).toBe("/api/v1/sweep/axis");
  const changed = await change(page, "PUT", "/api/v1/sweep", Sweep);
  expect(changed).toEqual({ problem: "The server does not answer." });
});
