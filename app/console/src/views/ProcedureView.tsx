// SPDX-License-Identifier: Apache-2.0
import { Aim } from "../panels/procedure/Aim";
import { Axes } from "../panels/procedure/Axes";
import { Drawing } from "../panels/procedure/Drawing";
import { Log } from "../panels/log/Log";
import { Procedure } from "../panels/procedure/Procedure";
import { Targeting } from "../panels/procedure/Targeting";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

/**
 * From START_UP to the target.
 *
 * @satisfies SWR-CON-042
 */
export function ProcedureView({
  view,
  robot,
  operation,
  outlook,
}: ViewProperties) {
  return (
    <>
      <Panel title="Procedure" className="panel-wide">
        <Procedure
          status={robot.status}
          outlook={outlook}
          operation={operation}
        />
      </Panel>
      <Panel title="Drawing" className="panel-wide">
        <Drawing robot={robot} page={operation.page} />
      </Panel>
      <Panel title="Axes" className="panel-wide">
        <Axes axes={robot.motors.axes} />
      </Panel>
      <Panel title="Targeting">
        <Targeting targeting={robot.targeting} />
      </Panel>
      <Panel title="Aim">
        <Aim robot={robot} outlook={outlook} operation={operation} />
      </Panel>
      <Panel title="Log" className="panel-wide">
        <Log log={view.log} />
      </Panel>
    </>
  );
}
