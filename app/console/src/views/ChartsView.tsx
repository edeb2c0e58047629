// SPDX-License-Identifier: Apache-2.0
import { Charts } from "../panels/system/Charts";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

/** The states of the charts. */
export function ChartsView({ robot }: ViewProperties) {
  return (
    <Panel title="Charts" className="panel-wide">
      <Charts robot={robot} />
    </Panel>
  );
}
