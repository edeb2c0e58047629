// SPDX-License-Identifier: Apache-2.0
import { memo } from "react";
import type { EventSeverity, LogEntry } from "@interface";
import { formatUtc } from "../../words/format";
import type { Level } from "../../state/lamps";
import { Shape } from "../../parts/drawn/Shape";
import "./Log.css";

const levels: Readonly<Record<EventSeverity, Level>> = {
  INFORMATION: "normal",
  WARNING: "attention",
  CRITICAL: "fault",
};

/** Cycles of 1 ms since control started. */
function timeText(cycle: number): string {
  return `${(cycle / 1000).toFixed(1)} s`;
}

const Entry = memo(function Entry({ entry }: { entry: LogEntry }) {
  const level = levels[entry.severity];
  return (
    <tr data-level={level}>
      <td className="number">
        <time dateTime={entry.utc}>{formatUtc(entry.utc)}</time>{" "}
        <span className="log-since">{timeText(entry.cycle)}</span>
      </td>
      <td className="log-severity">
        <Shape level={level} />
        <span>{entry.severity.toLowerCase()}</span>
      </td>
      <td>{entry.text}</td>
    </tr>
  );
});

/** Events, newest first; nothing while there are none. */
export const Log = memo(function Log({
  log,
  label = "Last events",
}: {
  log: readonly LogEntry[];
  label?: string;
}) {
  return (
    <div className="log" tabIndex={0} role="region" aria-label={label}>
      {log.length > 0 && (
        <table>
          <thead>
            <tr>
              <th scope="col" className="number">
                UTC, since start
              </th>
              <th scope="col" className="log-severity">
                <span>Severity</span>
              </th>
              <th scope="col">What happened</th>
            </tr>
          </thead>
          <tbody>
            {log.map((entry) => (
              <Entry key={entry.number} entry={entry} />
            ))}
          </tbody>
        </table>
      )}
    </div>
  );
});
