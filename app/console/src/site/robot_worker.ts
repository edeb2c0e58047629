// SPDX-License-Identifier: Apache-2.0
// The worker that has the robot of a page.
import { BEAT_MS, RobotDesk } from "./desk";
import { reportOf, sceneOf } from "./link";
import type { Order, Report } from "./messages";
import { moduleOf } from "./packed";
import { ServedRobot } from "./served_robot";

type Start = Extract<Order, { kind: "start" }>;

const tell = (report: Report) => postMessage(report);
let desk: Promise<RobotDesk> | null = null;

async function start(order: Start): Promise<RobotDesk> {
  const module = await moduleOf(order.packed);
  const served = new ServedRobot(module);
  const { robot, seed, inputs } = sceneOf(order, served.vocabulary);
  served.start(robot, seed, order.utcS);
  const now = performance.now();
  const started = new RobotDesk(served, inputs, tell, now);
  setInterval(() => started.beat(performance.now()), BEAT_MS);
  return started;
}

addEventListener("message", ({ data }: MessageEvent<Order>) => {
  if (data.kind === "start") {
    desk = start(data);
    desk.catch((failure: Error) => tell(reportOf(failure)));
  } else {
    desk?.then(
      (one) => one.take(data, performance.now()),
      () => undefined, // It was told.
    );
  }
});
