// SPDX-License-Identifier: Apache-2.0
// Rule under test: the robot of a page lives by the clock, answers, reports news, and after a failure does nothing more.
import { beforeEach, expect, test, vi } from "vitest";
import { BEAT_MS, RobotHost, REPORT_MS } from "./robot_host";
import { readVocabulary, type Input } from "../what_if/scene_text";
import type { Report } from "./messages";
import type { Answered, Asked, ServedRobot, Reported } from "./served_robot";

const bodies: Record<string, string> = {
  "/api/v1/robot":
    '{"name":"neuro","checksum":"a78c5496","axes":[{"name":"head"}]}',
  "/api/v1/status": '{"build_id":"b1"}',
  "/api/v1/motors": '"m"',
  "/api/v1/targeting": '"t"',
};
const STATE = '{"status":{"build_id":"b1"},"motors":"m","targeting":"t"}';

class FakeRobot implements Pick<
  ServedRobot,
  "step" | "act" | "ask" | "listen" | "stay" | "cycles" | "done" | "vocabulary"
> {
  cycles = 0;
  news: Reported[] = [];
  stay = vi.fn();
  acted: [number, string][] = [];
  vocabulary = readVocabulary(
    "order estop pull\norder keep WHO\norder card SLOT silent|hot\n",
  );
  private orders: Input[] = [];

  act({ words }: Input): void {
    if (words[0] === "card") {
      throw new Error("No such card.");
    }
    this.acted.push([this.cycles, words.join(" ")]);
  }

  step(cycles: number): void {
    this.cycles += cycles;
  }

  ask({ method, address }: Asked): Answered {
    if (method === "PUT") {
      this.orders.push(input(this.cycles, "pedal press"));
    }
    this.cycles += method === "POST" ? 30 : 0;
    const body = bodies[address] ?? "";
    return { status: 200, reason: "OK", headers: [], body };
  }

  listen(): Reported[] {
    return this.news.splice(0);
  }

  done(): Input[] {
    return this.orders.splice(0);
  }
}

const input = (cycle: number, words: string): Input => ({
  cycle,
  words: words.split(" "),
});

let robot: FakeRobot;
let reports: Report[];
let host: RobotHost;

const time = (cycles: number, end = cycles, later = 0): Report => ({
  kind: "time",
  cycles,
  end,
  later,
});

const ask = (method: string): Asked => ({
  method,
  address: "/api/v1/motors",
  headers: {},
  body: null,
});

function begin(inputs: Input[], at?: number): void {
  reports = [];
  host = new RobotHost(
    () => {
      robot = new FakeRobot();
      return robot as unknown as ServedRobot;
    },
    { robot: "neuro", seed: 7, inputs },
    (report) => reports.push(report),
    0,
    at,
  );
}

/** Those of a link, and the pedal in cycle 21. */
function live(inputs: Input[]): void {
  begin(inputs);
  host.beat(BEAT_MS);
  host.take({ kind: "ask", id: 1, asked: ask("PUT") }, BEAT_MS);
  host.beat(2 * BEAT_MS);
}

function goTo(cycle: number): void {
  host.take({ kind: "go", cycle }, 2 * BEAT_MS);
}

function share(): Report | undefined {
  host.take({ kind: "share" }, 2 * BEAT_MS);
  return reports.at(-1);
}

beforeEach(() => begin([]));

test("SWR-SITE-013 it says first what it is", () => {
  expect(reports).toEqual([
    {
      kind: "started",
      robot: "neuro",
      checksum: "a78c5496",
      build: "b1",
      inputs: ["estop pull", "card head silent", "card head hot"],
    },
  ]);
});

test("SWR-SITE-009 a beat lets pass what is due, less what a request has waited for", () => {
  host.take({ kind: "ask", id: 7, asked: ask("POST") }, 0);
  host.beat(BEAT_MS);
  host.beat(2 * BEAT_MS);
  expect(robot.cycles).toBe(1 + 2 * BEAT_MS);
  expect(reports.at(-1)).toMatchObject({ kind: "answer", id: 7 });
});

test("SWR-SITE-011 what the stream brings is reported, with the time", () => {
  robot.news = [
    { type: "log", data: "l" },
    { type: "state", data: "s" },
  ];
  host.beat(BEAT_MS);
  expect(reports.slice(1)).toEqual([
    { kind: "reported", type: "log", data: "l" },
    { kind: "reported", type: "state", data: "s" },
    time(1 + BEAT_MS),
  ]);
});

test("SWR-SITE-014 a robot that stands still is reported again, and one cycle is shown at once", () => {
  host.take({ kind: "pace", share: 0 }, 0);
  host.beat(REPORT_MS);
  const still = [{ kind: "reported", type: "state", data: STATE }, time(1)];
  expect(reports.slice(1)).toEqual(still);
  host.beat(REPORT_MS + BEAT_MS);
  expect(reports).toHaveLength(3);
  host.take({ kind: "step" }, REPORT_MS + BEAT_MS);
  expect(reports.at(-1)).toEqual(time(2));
});

test("SWR-SITE-010 who has opened the page stays logged in", () => {
  for (let ms = 0; ms <= 121_000; ms += 250) {
    host.beat(ms);
  }
  expect(robot.stay).toHaveBeenCalledTimes(2);
});

test("SWR-SITE-011 a robot that has failed says so once, and is done", () => {
  const step = vi.spyOn(robot, "step").mockImplementation(() => {
    throw new Error("Contract served/310 is broken, report this.");
  });
  host.beat(BEAT_MS);
  host.beat(2 * BEAT_MS);
  expect(step).toHaveBeenCalledOnce();
  expect(reports.at(-1)).toEqual({
    kind: "failed",
    reason: "Contract served/310 is broken, report this.",
  });
});

test("SWR-SITE-025 each input of a link is done before its cycle, whatever the beat", () => {
  begin([
    input(0, "estop reset"),
    input(7, "pedal press"),
    input(7, "scanner on"),
    input(BEAT_MS + 1, "pedal release"),
  ]);
  host.beat(BEAT_MS);
  expect(robot.cycles).toBe(1 + BEAT_MS);
  host.beat(2 * BEAT_MS);
  expect(robot.cycles).toBe(1 + 2 * BEAT_MS);
  expect(robot.acted).toEqual([
    [0, "estop reset"],
    [7, "pedal press"],
    [7, "scanner on"],
    [BEAT_MS + 1, "pedal release"],
  ]);
});

test("SWR-SITE-025 one cycle in a pause brings its inputs, and those that a request has waited over come behind it", () => {
  begin([input(1, "pedal press"), input(9, "pedal release")]);
  host.take({ kind: "pace", share: 0 }, 0);
  host.take({ kind: "step" }, 0);
  host.take({ kind: "ask", id: 7, asked: ask("POST") }, 0);
  expect(robot.acted).toEqual([[1, "pedal press"]]);
  host.take({ kind: "step" }, 0);
  expect(robot.acted.at(-1)).toEqual([32, "pedal release"]);
  expect(robot.cycles).toBe(33);
});

test("SWR-SITE-026 a link whose input is refused is over, in words, and nothing else is shown", () => {
  begin([input(5, "card 11 silent")]);
  host.beat(BEAT_MS);
  host.beat(2 * BEAT_MS);
  expect(robot.cycles).toBe(5);
  expect(reports.at(-1)).toEqual({
    kind: "refused",
    reason: "Cycle 5, card 11 silent: No such card.",
  });
});

test("SWR-SITE-030 what a link and the page have done is shared as one link", () => {
  live([input(7, "estop pull"), input(99, "estop reset")]);
  expect(share()).toEqual({
    kind: "shared",
    scene: "robot=neuro&seed=7&inputs=7:estop,pull;21:pedal,press",
    inputs: 2,
    cycle: 41,
  });
});

test("SWR-SITE-030 what is not known any more is not shared, with the reason", () => {
  robot.done = () => null as unknown as Input[];
  host.beat(BEAT_MS);
  expect(share()).toEqual({
    kind: "unshared",
    reason: "More than 10,000 inputs were given, and are not kept.",
  });
  const before = robot;
  goTo(1);
  expect(robot).toBe(before);
});

test("SWR-SITE-031 it goes back by a robot to which the same is done, and stands still", () => {
  live([input(7, "estop pull"), input(99, "estop reset")]);
  const before = robot;
  goTo(22);
  expect(robot).not.toBe(before);
  expect(robot.acted).toEqual([
    [7, "estop pull"],
    [21, "pedal press"],
  ]);
  expect(reports.slice(-3)).toEqual([
    { kind: "restarted" },
    { kind: "reported", type: "state", data: STATE },
    time(22, 41, 1),
  ]);
  host.beat(9 * BEAT_MS);
  expect(robot.cycles).toBe(22);
});

test("SWR-SITE-031 from there it goes forth to where it was, and no further", () => {
  live([]);
  goTo(20);
  expect(reports.at(-1)).toEqual(time(20, 41, 1));
  goTo(41);
  expect(reports.at(-1)).toEqual(time(41));
  expect(robot.acted).toEqual([[21, "pedal press"]]);
  const before = robot;
  [0, 42].forEach(goTo);
  expect(robot).toBe(before);
});

test("SWR-SITE-031 when time goes on, what came later is forgotten", () => {
  live([input(99, "estop reset")]);
  goTo(20);
  host.take({ kind: "step" }, 2 * BEAT_MS);
  expect(reports.at(-1)).toEqual(time(21));
  for (let cycle = 22; cycle < 110; cycle++) {
    host.take({ kind: "step" }, 2 * BEAT_MS);
  }
  expect(robot.acted).toEqual([]);
  expect(share()).toMatchObject({ inputs: 0 });
});

test("SWR-SITE-033 a link with a question stands still where it asks, and nothing moves from there", () => {
  begin([input(7, "estop pull"), input(99, "estop reset")], 50);
  host.beat(BEAT_MS);
  expect(robot.cycles).toBe(50);
  expect(robot.acted).toEqual([[7, "estop pull"]]);
});

test("SWR-SITE-033 what cannot be asked is refused, and the robot goes on as it was", () => {
  const question = { input: "x", seconds: 1 };
  host.take({ kind: "compare", question }, 0);
  expect(reports.at(-1)).toMatchObject({ kind: "compared", lines: [] });
  host.beat(BEAT_MS);
  expect(robot.cycles).toBe(1 + BEAT_MS);
});
