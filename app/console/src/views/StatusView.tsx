// SPDX-License-Identifier: Apache-2.0
import { useRobot } from "../state/outlook";
import { CardHealth } from "../panels/system/CardHealth";
import { Cards } from "../panels/system/Cards";
import { Loop } from "../panels/system/Loop";
import { Stages } from "../panels/procedure/Stages";
import { System } from "../panels/system/System";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

/** The parts of the robot, and their state. */
export function StatusView({ robot, operation }: ViewProperties) {
  const { status } = robot;
  const told = useRobot(operation.page, status.boot_id);
  return (
    <>
      <Panel title="Cards" className="panel-wide">
        <Cards cards={status.cards} slots={told?.slots ?? 0} />
      </Panel>
      <Panel title="Health" className="panel-wide">
        <CardHealth cards={status.cards} />
      </Panel>
      <Panel title="System">
        <System status={status} robot={told} />
      </Panel>
      <Panel title="Control loop">
        <Loop status={status} />
        {!status.time.is_elastic && <Stages stages={status.loop.stages} />}
      </Panel>
    </>
  );
}
