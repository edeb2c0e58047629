// SPDX-License-Identifier: Apache-2.0
import { LogFiles, RecordingFiles } from "../panels/log/Archive";
import { LogFileLevel } from "../panels/log/LogFileLevel";
import { LogNote } from "../panels/log/LogNote";
import { LogSearch } from "../panels/log/LogSearch";
import { Panel } from "../parts/Panel";
import type { ViewProperties } from "./view";

/** The events of the log. */
export function LogView({ view, operation }: ViewProperties) {
  const { page } = operation;
  return (
    <>
      <Panel title="Log" className="panel-wide">
        <LogNote operation={operation} />
        <LogSearch page={page} newest={view.log[0]} />
      </Panel>
      <Panel title="Log files" className="panel-wide">
        <LogFileLevel operation={operation} />
        <LogFiles page={page} />
      </Panel>
      <Panel title="Recordings" className="panel-wide">
        <RecordingFiles page={page} />
      </Panel>
    </>
  );
}
