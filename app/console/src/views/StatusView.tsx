// SPDX-License-Identifier: Apache-2.0
import { useCommanding } from "../state/operation";
import { reasonAgainst, useRobot } from "../state/outlook";
import { CardHealth } from "../panels/system/CardHealth";
import { Cards } from "../panels/system/Cards";
import { Forces } from "../panels/system/Forces";
import { Loop } from "../panels/system/Loop";
import { Stages } from "../panels/procedure/Stages";
import { System } from "../panels/system/System";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

/** The parts of the robot, and their state. */
export function StatusView({ robot, operation, outlook }: ViewProperties) {
  const { status } = robot;
  const reported = useRobot(operation.page, status.boot_id);
  const commanding = useCommanding(operation, status.authority);
  return (
    <>
      <Panel title="Cards" className="panel-wide">
        <Cards cards={status.cards} slots={reported?.slots ?? 0} />
      </Panel>
      <Panel title="Health" className="panel-wide">
        <CardHealth cards={status.cards} />
      </Panel>
      {status.forces.length > 0 && (
        <Panel title="Forces" className="panel-wide">
          <Forces
            forces={status.forces}
            commanding={commanding}
            refusal={reasonAgainst(outlook, "ZERO_FORCE")}
          />
        </Panel>
      )}
      <Panel title="System">
        <System status={status} robot={reported} />
      </Panel>
      <Panel title="Control loop">
        <Loop status={status} />
        {!status.time.is_elastic && <Stages stages={status.loop.stages} />}
      </Panel>
    </>
  );
}
