// SPDX-License-Identifier: Apache-2.0
import type { LogEntry } from "@interface";
import { formatUtc } from "../words/format";

/** All events; the button of one goes to its cycle. */
export function Events({
  events,
  cycle,
  onCycle,
}: {
  events: readonly LogEntry[];
  cycle: number;
  onCycle: (cycle: number) => void;
}) {
  return (
    <div
      className="replay-events"
      role="region"
      aria-label="All events"
      tabIndex={0}
    >
      <table>
        <thead>
          <tr>
            <th scope="col">Cycle</th>
            <th scope="col" className="number">
              UTC
            </th>
            <th scope="col">Severity</th>
            <th scope="col">What happened</th>
          </tr>
        </thead>
        <tbody>
          {events.map((entry) => (
            <tr
              key={entry.number}
              aria-current={entry.cycle === cycle ? "true" : undefined}
            >
              <td>
                <button
                  type="button"
                  aria-label={`Go to cycle ${entry.cycle}: ${entry.text}`}
                  onClick={() => onCycle(entry.cycle)}
                >
                  {entry.cycle}
                </button>
              </td>
              <td className="number">{formatUtc(entry.utc)}</td>
              <td>{entry.severity.toLowerCase()}</td>
              <td>{entry.text}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
