// SPDX-License-Identifier: Apache-2.0
import { CardLamps } from "../panels/Lamps";
import { Loop } from "../panels/Loop";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

/** What the robot is made of, and how it fares. */
export function StatusView({ robot }: ViewProperties) {
  return (
    <>
      <Panel title="Cards" className="panel-wide">
        <CardLamps status={robot.status} />
      </Panel>
      <Panel title="Control loop">
        <Loop status={robot.status} />
      </Panel>
    </>
  );
}
