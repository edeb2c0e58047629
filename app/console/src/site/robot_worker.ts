// SPDX-License-Identifier: Apache-2.0
// The worker that has the robot of a page.
import { BEAT_MS, RobotDesk } from "./desk";
import type { Order, Report } from "./messages";
import { ServedRobot } from "./served_robot";

type Start = Extract<Order, { kind: "start" }>;

const tell = (report: Report) => postMessage(report);
let desk: Promise<RobotDesk> | null = null;

async function unpack(packed: string): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(packed), (one) => one.charCodeAt(0));
  const stream = new Blob([bytes])
    .stream()
    .pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

async function start({ packed, robot, seed, utcS }: Start): Promise<RobotDesk> {
  const module = await WebAssembly.compile(await unpack(packed));
  const served = new ServedRobot(module);
  served.start(robot, seed, utcS);
  const started = new RobotDesk(served, tell, performance.now());
  setInterval(() => started.beat(performance.now()), BEAT_MS);
  return started;
}

addEventListener("message", ({ data }: MessageEvent<Order>) => {
  if (data.kind === "start") {
    desk = start(data);
    desk.catch((failure: Error) =>
      tell({ kind: "failed", reason: failure.message }),
    );
  } else {
    desk?.then(
      (one) => one.take(data, performance.now()),
      () => undefined, // It was told.
    );
  }
});
