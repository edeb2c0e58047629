// SPDX-License-Identifier: Apache-2.0
import { Ports } from "../panels/Ports";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

/** Who is connected, and by what. */
export function CommunicationView({ robot }: ViewProperties) {
  return (
    <Panel title="OpenIGTLink" className="panel-wide">
      <Ports ports={robot.status.ports} />
    </Panel>
  );
}
