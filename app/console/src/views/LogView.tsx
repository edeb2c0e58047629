// SPDX-License-Identifier: Apache-2.0
import { Log } from "../panels/Log";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

/** What has happened. */
export function LogView({ view }: ViewProperties) {
  return (
    <Panel title="Log" className="panel-wide">
      <Log log={view.log} />
    </Panel>
  );
}
