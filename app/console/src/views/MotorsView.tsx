// SPDX-License-Identifier: Apache-2.0
import { Axes } from "../panels/Axes";
import { Motion } from "../panels/Motion";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

/** Each axis by itself. */
export function MotorsView({ robot, operation, outlook }: ViewProperties) {
  return (
    <>
      <Panel title="Axes" className="panel-wide">
        <Axes axes={robot.motors.axes} />
      </Panel>
      <Panel title="Motion" className="panel-wide">
        <Motion robot={robot} outlook={outlook} operation={operation} />
      </Panel>
    </>
  );
}
