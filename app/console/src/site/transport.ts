// SPDX-License-Identifier: Apache-2.0
// The transport of this page, whose file has the robot in it.
import { choiceIn } from "./address";
import { RobotTransport } from "./robot_transport";
import RobotWorker from "./robot_worker?worker&inline";

const MS_PER_S = 1000;

export const transport = new RobotTransport(new RobotWorker(), {
  kind: "start",
  packed: document.getElementById("robot")?.textContent ?? "",
  utcS: Math.floor(Date.now() / MS_PER_S),
  ...choiceIn(location.hash),
});
