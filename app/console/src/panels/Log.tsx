// SPDX-License-Identifier: Apache-2.0
import { memo } from "react";
import type { LogEntry } from "@interface";
import type { Level } from "../lamps";
import { Shape } from "../parts/Shape";

const levels: Readonly<Record<string, Level>> = {
  INFORMATION: "normal",
  WARNING: "attention",
  CRITICAL: "fault",
};

/** Cycles of 1 ms since control started. */
function timeText(cycle: number): string {
  return `${(cycle / 1000).toFixed(1)} s`;
}

function Entry({ entry }: { entry: LogEntry }) {
  const level = levels[entry.severity] ?? "unknown";
  return (
    <tr data-level={level}>
      <td className="number">{timeText(entry.cycle)}</td>
      <td className="log-severity">
        <Shape level={level} />
        {entry.severity.toLowerCase()}
      </td>
      <td>{entry.text}</td>
    </tr>
  );
}

/** The last events, newest first. */
export const Log = memo(function Log({ log }: { log: readonly LogEntry[] }) {
  return (
    <div className="log" tabIndex={0} role="region" aria-label="Last events">
      <table>
        <thead>
          <tr>
            <th scope="col" className="number">
              Time
            </th>
            <th scope="col">Severity</th>
            <th scope="col">What happened</th>
          </tr>
        </thead>
        <tbody>
          {log.map((entry) => (
            <Entry key={entry.number} entry={entry} />
          ))}
        </tbody>
      </table>
    </div>
  );
});
