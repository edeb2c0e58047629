// SPDX-License-Identifier: Apache-2.0
// The worker that has the robot of a page.
import { askedIn } from "./address";
import { BEAT_MS, RobotHost } from "./robot_host";
import { onLink, reportOf, sceneOf } from "./link";
import type { Order, Report } from "./messages";
import { moduleOf } from "./packed";
import { ServedRobot } from "./served_robot";

type Start = Extract<Order, { kind: "start" }>;

const send = (report: Report) => postMessage(report);
let host: Promise<RobotHost> | null = null;

async function start(order: Start): Promise<RobotHost> {
  const module = await moduleOf(order.packed);
  const { vocabulary } = new ServedRobot(module);
  const scene = sceneOf(order, vocabulary);
  const begin = () => {
    const served = new ServedRobot(module);
    onLink(() => served.start(scene.robot, scene.seed, order.utcS));
    return served;
  };
  const started = new RobotHost(
    begin,
    scene,
    send,
    performance.now(),
    askedIn(order.scene ?? "")[1]?.cycle,
  );
  setInterval(() => started.beat(performance.now()), BEAT_MS);
  return started;
}

addEventListener("message", ({ data }: MessageEvent<Order>) => {
  if (data.kind === "start") {
    host = start(data);
    host.catch((failure: Error) => send(reportOf(failure)));
  } else {
    host?.then(
      (one) => one.take(data, performance.now()),
      () => undefined, // It was reported.
    );
  }
});
