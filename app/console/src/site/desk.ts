// SPDX-License-Identifier: Apache-2.0
// The robot at work for its page: it lives by the time of the world, answers, and tells what happens.
import type { Path, Robot, Status } from "@interface";
import type { Input } from "../what_if/scene_text";
import { onLink, reportOf } from "./link";
import { Pace } from "./pace";
import type { Order, Report } from "./messages";
import type { Answered, ServedRobot } from "./served_robot";

export const BEAT_MS = 20;
/** A robot that stands still or is slow is told of as often, that nobody takes it for silent. */
export const TELL_MS = 200;
/** Of the robot. */
const STAY_CYCLES = 60_000;

type Work = Exclude<Order, { kind: "start" }>;

export class RobotDesk {
  private readonly robot: ServedRobot;
  private inputs: readonly Input[];
  private readonly tell: (report: Report) => void;
  private readonly pace: Pace;
  private toldAtMs: number;
  private stayedAt = 0;
  private hasFailed = false;

  /** The robot is started, and no cycle has passed. `inputs` are done to it in their cycles. */
  constructor(
    robot: ServedRobot,
    inputs: readonly Input[],
    tell: (report: Report) => void,
    nowMs: number,
  ) {
    this.robot = robot;
    this.inputs = inputs;
    this.tell = tell;
    this.pace = new Pace(nowMs);
    this.toldAtMs = nowMs;
    this.try(() => this.introduce());
  }

  take(order: Work, nowMs: number): void {
    this.try(() => this.work(order, nowMs));
  }

  /** Each BEAT_MS. */
  beat(nowMs: number): void {
    this.try(() => {
      this.pass(this.pace.due(nowMs));
      if (this.robot.cycles - this.stayedAt >= STAY_CYCLES) {
        this.stayedAt = this.robot.cycles;
        this.robot.stay();
      }
      this.tellNews(nowMs);
    });
  }

  private work(order: Work, nowMs: number): void {
    switch (order.kind) {
      case "ask": {
        const before = this.robot.cycles;
        const answered = this.robot.ask(order.asked);
        this.pace.spend(this.robot.cycles - before);
        return this.tell({ kind: "answer", id: order.id, answered });
      }
      case "pace":
        return this.pace.set(order.share, nowMs);
      case "step":
        this.pass(1);
        return this.tellState(nowMs);
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
      this.act(next);
      this.inputs = this.inputs.slice(1);
      [next] = this.inputs;
    }
    this.robot.step(end - this.robot.cycles);
  }

  private act(input: Input): void {
    const where = `Cycle ${input.cycle}, ${input.words.join(" ")}: `;
    onLink(() => this.robot.act(input), where);
  }

  private introduce(): void {
    this.pass(1);
    const { name, checksum } = this.look<Robot>("/api/v1/robot");
    const { build_id: build } = this.look<Status>("/api/v1/status");
    this.tell({ kind: "started", robot: name, checksum, build });
  }

  private tellNews(nowMs: number): void {
    const news = this.robot.listen();
    news.forEach((told) => this.tell({ kind: "told", ...told }));
    if (news.some(({ type }) => type === "state")) {
      this.tellTime(nowMs);
    } else if (nowMs - this.toldAtMs >= TELL_MS) {
      this.tellState(nowMs);
    }
  }

  /** Of this cycle, as the stream would say it. */
  private tellState(nowMs: number): void {
    const [status, motors, targeting] = (
      ["/api/v1/status", "/api/v1/motors", "/api/v1/targeting"] as const
    ).map((path) => this.read(path).body);
    const data = `{"status":${status},"motors":${motors},"targeting":${targeting}}`;
    this.tell({ kind: "told", type: "state", data });
    this.tellTime(nowMs);
  }

  private tellTime(nowMs: number): void {
    this.toldAtMs = nowMs;
    this.tell({ kind: "time", cycles: this.robot.cycles });
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
      this.tell(reportOf(failure as Error));
    }
  }
}
