// SPDX-License-Identifier: Apache-2.0
import { Communication } from "@interface";
import { useAnswer } from "../state/answer";
import { useCommanding } from "../state/operation";
import { Connections } from "../panels/system/Connections";
import { Pages } from "../panels/system/Pages";
import { Ports } from "../panels/system/Ports";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

export const ASK_AGAIN_MS = 1000;

/** The connected clients, and their ports. */
export function CommunicationView({ robot, operation }: ViewProperties) {
  const { page } = operation;
  const { obstacle } = useCommanding(operation, robot.status.authority);
  const [communication, takeAnswer] = useAnswer(
    page,
    "/api/v1/communication",
    Communication,
    ASK_AGAIN_MS,
  );
  return (
    <>
      <Panel title="Connections of OpenIGTLink" className="panel-wide">
        {communication === null ? (
          <p>Not known yet.</p>
        ) : (
          <Connections
            connections={communication.connections}
            page={page}
            obstacle={obstacle}
            takeAnswer={takeAnswer}
          />
        )}
      </Panel>
      <Panel title="Pages of the console">
        {communication === null ? (
          <p>Not known yet.</p>
        ) : (
          <Pages pages={communication.pages} own={page.number} />
        )}
      </Panel>
      <Panel title="Ports of OpenIGTLink">
        <Ports ports={robot.status.ports} />
      </Panel>
    </>
  );
}
