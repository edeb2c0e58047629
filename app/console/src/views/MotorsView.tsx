// SPDX-License-Identifier: Apache-2.0
import { lazy, Suspense } from "react";
import { Motors } from "../panels/motors/Motors";
import { Needle } from "../panels/modes/Needle";
import { Positions } from "../panels/motors/Positions";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

const Plots = lazy(async () => ({
  default: (await import("../panels/motors/Plots")).Plots,
}));

/** Each axis by itself. */
export function MotorsView({
  robot,
  operation,
  outlook,
  trace,
}: ViewProperties) {
  const properties = { robot, operation, outlook };
  return (
    <>
      <Panel title="Motors" className="panel-wide">
        <Motors {...properties} />
      </Panel>
      <Panel title="Plots" className="panel-wide">
        <Suspense fallback={<p>Loading plots…</p>}>
          <Plots axes={robot.motors.axes} trace={trace} />
        </Suspense>
      </Panel>
      <Panel title="Needle and poses" className="panel-wide">
        <Needle {...properties} />
      </Panel>
      <Panel title="Saved positions" className="panel-wide">
        <Positions robot={robot} operation={operation} />
      </Panel>
    </>
  );
}
