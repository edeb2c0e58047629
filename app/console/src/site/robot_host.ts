// SPDX-License-Identifier: Apache-2.0
// The robot at work for its page: it lives by the time of the world, answers, and reports events.
import type { Path, Robot, Status } from "@interface";
import type { Input, Scene } from "../what_if/scene_text";
import { Course } from "./course";
import { onLink, reportOf } from "./link";
import { Pace } from "./pace";
import { answerOf, inputsOf, type Question } from "./question";
import type { Order, Report } from "./messages";
import type { Answered, ServedRobot } from "./served_robot";

export const BEAT_MS = 20;
/** A robot that stands still or is slow is reported as often, so that no page takes it for silent. */
export const REPORT_MS = 200;
/** Cycles of the robot between two stays. */
const STAY_CYCLES = 60_000;

type Work = Exclude<Order, { kind: "start" }>;

export class RobotHost {
  private readonly begin: () => ServedRobot;
  private robot: ServedRobot;
  private readonly scene: Scene;
  private course = new Course();
  /** To come. */
  private inputs: readonly Input[];
  /** Where time had come to when it was put back, and what came until then. */
  private end = 0;
  private later: readonly Input[] = [];
  private readonly send: (report: Report) => void;
  private readonly pace: Pace;
  private reportedAtMs: number;
  private stayedAt = 0;
  private hasFailed = false;

  /** `begin` starts the robot of the scene, always the same. Its inputs are done in their cycles. `at`: where time stands still first. */
  constructor(
    begin: () => ServedRobot,
    scene: Scene,
    send: (report: Report) => void,
    nowMs: number,
    at?: number,
  ) {
    this.begin = begin;
    this.robot = begin();
    this.scene = scene;
    this.inputs = scene.inputs;
    this.send = send;
    this.pace = new Pace(nowMs);
    this.reportedAtMs = nowMs;
    this.try(() => {
      this.introduce();
      if (at !== undefined) {
        this.end = at;
        this.goTo(at, nowMs);
      }
    });
  }

  take(order: Work, nowMs: number): void {
    this.try(() => this.work(order, nowMs));
  }

  /** Each BEAT_MS. */
  beat(nowMs: number): void {
    this.try(() => {
      this.goOn(this.pace.due(nowMs));
      this.tellNews(nowMs);
    });
  }

  private work(order: Work, nowMs: number): void {
    switch (order.kind) {
      case "ask": {
        const before = this.robot.cycles;
        const answered = this.robot.ask(order.asked);
        const waited = this.robot.cycles - before;
        this.pace.spend(waited);
        this.note();
        this.forget(waited);
        return this.send({ kind: "answer", id: order.id, answered });
      }
      case "pace":
        return this.pace.set(order.share, nowMs);
      case "step":
        this.goOn(1);
        return this.tellState(nowMs);
      case "go":
        return this.goTo(order.cycle, nowMs);
      case "share":
        return this.send(this.share());
      case "compare":
        return this.send(this.compare(order.question));
    }
  }

  private share(): Report {
    try {
      const scene = this.course.write(this.scene);
      const inputs = this.course.inputs.length;
      return { kind: "shared", scene, inputs, cycle: this.robot.cycles };
    } catch (failure) {
      return { kind: "unshared", reason: (failure as Error).message };
    }
  }

  private compare(question: Question): Report {
    const inputs = this.toCome;
    const { cycles: cycle } = this.robot;
    const compared = { kind: "compared", question, cycle } as const;
    try {
      const [run, other] = [this.robot.copy(), this.robot.copy()];
      const lines = answerOf(question, inputs, run, other);
      const scene = this.write(inputs);
      return { ...compared, lines, problem: null, scene };
    } catch (failure) {
      const problem = (failure as Error).message;
      return { ...compared, lines: [], problem, scene: null };
    }
  }

  /** Null: it is no link. */
  private write(later: readonly Input[]): string | null {
    try {
      return this.course.write(this.scene, later);
    } catch {
      return null;
    }
  }

  private get toCome(): readonly Input[] {
    return [...this.later, ...this.inputs];
  }

  /**
   * To the state before any cycle that has been, by executing what was done until then anew; there it stands still.
   *
   * @satisfies SWR-SITE-031
   */
  private goTo(cycle: number, nowMs: number): void {
    const end = Math.max(this.end, this.robot.cycles);
    if (this.course.problem !== null || cycle < 1 || cycle > end) {
      return;
    }
    const all = [...this.course.inputs, ...this.toCome];
    this.pace.set(0, nowMs);
    this.restart(all.filter((input) => input.cycle < cycle));
    while (this.robot.cycles < cycle) {
      this.pass(Math.min(STAY_CYCLES, cycle - this.robot.cycles));
    }
    this.end = end;
    this.later = all.filter((input) => input.cycle >= cycle);
    this.send({ kind: "restarted" });
    this.tellState(nowMs);
  }

  private restart(inputs: readonly Input[]): void {
    this.robot = this.begin();
    this.course = new Course();
    this.inputs = inputs;
    this.stayedAt = 0;
  }

  private goOn(cycles: number): void {
    this.pass(cycles);
    this.forget(cycles);
  }

  /** When time goes on. */
  private forget(cycles: number): void {
    if (cycles > 0) {
      this.end = 0;
      this.later = [];
    }
  }

  /**
   * Lets so many cycles pass, with the inputs that are due in each. Those of cycles that a request has waited for come behind it.
   *
   * @satisfies SWR-SITE-025
   */
  private pass(cycles: number): void {
    const end = this.robot.cycles + cycles;
    let [next] = this.inputs;
    while (next !== undefined && next.cycle < end) {
      this.robot.step(Math.max(0, next.cycle - this.robot.cycles));
      this.note();
      this.act(next);
      this.inputs = this.inputs.slice(1);
      [next] = this.inputs;
    }
    this.robot.step(end - this.robot.cycles);
    this.note();
    if (this.robot.cycles - this.stayedAt >= STAY_CYCLES) {
      this.stayedAt = this.robot.cycles;
      this.robot.stay();
    }
  }

  private note(): void {
    this.course.add(this.robot.done());
  }

  private act(input: Input): void {
    const where = `Cycle ${input.cycle}, ${input.words.join(" ")}: `;
    onLink(() => this.robot.act(input), where);
    this.course.add([{ cycle: this.robot.cycles, words: input.words }]);
  }

  private introduce(): void {
    this.pass(1);
    const { name, checksum, axes } = this.look<Robot>("/api/v1/robot");
    const { build_id: build } = this.look<Status>("/api/v1/status");
    const names = axes.map((axis) => axis.name);
    const inputs = inputsOf(this.robot.vocabulary, names);
    this.send({ kind: "started", robot: name, checksum, build, inputs });
  }

  private tellNews(nowMs: number): void {
    const news = this.robot.listen();
    news.forEach((reported) => this.send({ kind: "reported", ...reported }));
    if (news.some(({ type }) => type === "state")) {
      this.tellTime(nowMs);
    } else if (nowMs - this.reportedAtMs >= REPORT_MS) {
      this.tellState(nowMs);
    }
  }

  /** Reports the state of this cycle, as the stream would. */
  private tellState(nowMs: number): void {
    const [status, motors, targeting] = (
      ["/api/v1/status", "/api/v1/motors", "/api/v1/targeting"] as const
    ).map((path) => this.read(path).body);
    const data = `{"status":${status},"motors":${motors},"targeting":${targeting}}`;
    this.send({ kind: "reported", type: "state", data });
    this.tellTime(nowMs);
  }

  private tellTime(nowMs: number): void {
    this.reportedAtMs = nowMs;
    const { cycles } = this.robot;
    const end = Math.max(this.end, cycles);
    const later = this.later.length;
    this.send({ kind: "time", cycles, end, later });
  }

  private read(address: Path): Answered {
    return this.robot.ask({ method: "GET", address, headers: {}, body: null });
  }

  private look<Answer>(path: Path): Answer {
    return JSON.parse(this.read(path).body) as Answer;
  }

  /** A robot that has failed once is no robot any more. */
  private try(act: () => void): void {
    if (this.hasFailed) {
      return;
    }
    try {
      act();
    } catch (failure) {
      this.hasFailed = true;
      this.send(reportOf(failure as Error));
    }
  }
}
