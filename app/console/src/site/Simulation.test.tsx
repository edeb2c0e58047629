// SPDX-License-Identifier: Apache-2.0
// Rule under test: the page says what it is, and time in it is in the hands of who sees it.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { RobotView } from "./robot_transport";
import { Simulation } from "./Simulation";

let view: RobotView;
let changed: () => void;
const setPace = vi.fn();
const step = vi.fn();
const goTo = vi.fn();
const shareCourse = vi.fn();
const compare = vi.fn();
const onAnew = vi.fn();

function replace(change: Partial<RobotView>): void {
  act(() => {
    view = { ...view, ...change };
    changed();
  });
}

beforeEach(() => {
  vi.clearAllMocks();
  view = {
    identity: null,
    cycles: 0,
    end: 0,
    later: 0,
    shared: null,
    inputs: ["estop pull", "pedal press"],
    compared: null,
    share: 1,
    failure: null,
    isRefused: false,
  };
  const subscribe = (listener: () => void) => {
    changed = listener;
    return () => undefined;
  };
  const commands = { setPace, step, goTo, shareCourse, compare };
  const robot = { subscribe, getView: () => view, ...commands };
  const names = ["neuro", "prostate"];
  const asked = { input: "card 3 silent", seconds: 5 };
  const properties = { robot, names, asked, onAnew };
  render(<Simulation {...properties} />);
});

afterEach(cleanup);

function button(name: string): HTMLButtonElement {
  return screen.getByRole("button", { name });
}

test("SWR-SITE-013 it is a simulation from the first moment, and its build and robot are named", () => {
  expect(screen.getByRole("note").textContent).toBe(
    "Simulation. No robot moves.",
  );
  replace({
    identity: { robot: "neuro", checksum: "a78c5496", build: "18ecb163e24e" },
  });
  expect(screen.getByText("File a78c5496, build 18ecb163e24e")).toBeTruthy();
  expect(screen.getByRole("note")).toBeTruthy();
});

test("SWR-SITE-012 the other robots are a link away", () => {
  replace({ identity: { robot: "neuro", checksum: "1", build: "2" } });
  const link = screen.getByRole("link", { name: "prostate" });
  expect(link.getAttribute("href")).toBe("#robot=prostate");
  expect(screen.queryByRole("link", { name: "neuro" })).toBeNull();
});

test("SWR-SITE-035 the page for recordings is a link away", () => {
  const link = screen.getByRole("link", { name: "Open a recording" });
  expect(link.getAttribute("href")).toBe("./replay.html");
});

test("SWR-SITE-014 time is slower, faster, stands still, and goes by cycles then", () => {
  for (const name of ["Pause", "A tenth", "Twice", "Real time"]) {
    fireEvent.click(button(name));
  }
  expect(setPace.mock.calls.flat()).toEqual([0, 0.1, 2, 1]);
  expect(button("Real time").getAttribute("aria-pressed")).toBe("true");
  expect(button("One cycle").disabled).toBe(true);
  replace({ share: 0, cycles: 1234 });
  expect(button("Pause").getAttribute("aria-pressed")).toBe("true");
  expect(screen.getByText("1.234 s, cycle 1234")).toBeTruthy();
  fireEvent.click(button("One cycle"));
  expect(step).toHaveBeenCalledOnce();
});

test("SWR-SITE-013 a robot that has failed is not shown as one, and is started anew", () => {
  replace({ failure: "Contract served/310 is broken, report this." });
  expect(screen.getByRole("alert").textContent).toContain("served/310");
  fireEvent.click(button("Start anew"));
  expect(onAnew).toHaveBeenCalledOnce();
});

test("SWR-SITE-026 a link that is refused is reported with the reason, and the way out", () => {
  replace({
    failure: "At character 27: “x” does not begin with CYCLE:.",
    isRefused: true,
  });
  expect(screen.getByRole("alert").textContent).toBe(
    "The link of this page is refused. At character 27: “x” does not begin with CYCLE:. A robot without it",
  );
  const out = screen.getByRole<HTMLAnchorElement>("link", {
    name: "A robot without it",
  });
  expect(out.hash).toBe("#robot=neuro");
});

test("SWR-SITE-032 time goes back by a cycle, a second, to the start and to any cycle", () => {
  expect(button("Back one cycle").disabled).toBe(true);
  replace({ cycles: 3000, end: 3000 });
  ["To the start", "Back 1 s", "Back one cycle"].forEach((name) =>
    fireEvent.click(button(name)),
  );
  const cycle = screen.getByLabelText<HTMLInputElement>("Cycle");
  fireEvent.change(cycle, { target: { value: "1234" } });
  fireEvent.click(button("Go to it"));
  expect(goTo.mock.calls.flat()).toEqual([1, 2000, 2999, 1234]);
  expect([cycle.min, cycle.max]).toEqual(["1", "3000"]);
  replace({ cycles: 500 });
  fireEvent.click(button("Back 1 s"));
  expect(goTo).toHaveBeenLastCalledWith(1);
});

test("SWR-SITE-032 who has gone back is informed of what is forgotten before time goes on", () => {
  const status = screen.getByRole("status");
  replace({ cycles: 3000, end: 3000 });
  expect(status.textContent).toBe("");
  replace({ cycles: 2000, later: 12 });
  expect(status.textContent).toBe(
    "It has been to cycle 3000. When time goes on from here, that is forgotten, with 12 inputs.",
  );
});

test("SWR-SITE-030 what was done is shown as a link, or the reason why not", () => {
  fireEvent.click(button("Share"));
  expect(shareCourse).toHaveBeenCalledOnce();
  const scene = "robot=neuro&seed=1&inputs=100:estop,pull";
  replace({ shared: { kind: "shared", scene, inputs: 1, cycle: 200 } });
  const link = screen.getByLabelText<HTMLInputElement>(
    "Link to the 1 inputs before cycle 200",
  );
  expect(link.value).toBe(`${location.href}#${scene}`);
  replace({ shared: { kind: "unshared", reason: "It is too long." } });
  expect(screen.getByRole("alert").textContent).toBe("It is too long.");
});

const question = { input: "estop pull", seconds: 4 };
const answer = {
  question,
  cycle: 1500,
  lines: [],
  problem: null,
  scene: "robot=neuro&seed=1&inputs=100:pedal,press",
};

test("SWR-SITE-033 what would be if is asked where time stands still, first what the link asks", () => {
  expect(button("Compare").disabled).toBe(true);
  expect(screen.getByText("Pause first.")).toBeTruthy();
  replace({ share: 0 });
  fireEvent.click(button("Compare"));
  expect(compare).toHaveBeenLastCalledWith({
    input: "card 3 silent",
    seconds: 5,
  });
  const input = screen.getByRole<HTMLInputElement>("combobox");
  expect([...(input.list?.options ?? [])].map(({ value }) => value)).toEqual([
    "estop pull",
    "pedal press",
  ]);
  fireEvent.change(input, { target: { value: "estop pull" } });
  fireEvent.change(screen.getByRole("spinbutton", { name: /Compared for/ }), {
    target: { value: "4" },
  });
  fireEvent.click(button("Compare"));
  expect(compare).toHaveBeenLastCalledWith(question);
});

test("SWR-SITE-033 the first difference is said, and a link asks for it again", () => {
  replace({ compared: { ...answer, lines: ["Cycle 1500", "state x"] } });
  expect(screen.getByText("Cycle 1500").nextSibling?.textContent).toBe(
    "state x",
  );
  const link = screen.getByLabelText<HTMLInputElement>("Link to this question");
  expect(link.value).toBe(
    `${location.href}#${answer.scene}&at=1500&if=estop,pull&for=4`,
  );
});

test("SWR-SITE-033 nothing is said to differ where nothing does, and what is no input is refused", () => {
  replace({ compared: answer });
  expect(
    screen.getByText("Nothing differs in 4 s with “estop pull”."),
  ).toBeTruthy();
  replace({ compared: { ...answer, scene: null, problem: "It is none." } });
  expect(screen.getByRole("alert").textContent).toBe("It is none.");
  expect(screen.queryByLabelText("Link to this question")).toBeNull();
});
