// SPDX-License-Identifier: Apache-2.0
import type { Stage } from "@interface";
import { WideTable } from "../../parts/WideTable";
import "./Stages.css";

/** Name of a class of times; each is twice as wide as the one before. */
export function className(index: number, count: number): string {
  const from = index === 0 ? 0 : 2 ** (index - 1);
  if (index === count - 1) {
    return `from ${from} µs`;
  }
  return index < 2 ? `${from} µs` : `${from}–${2 * from - 1} µs`;
}

/** Length of a bar, 0 to 100. One cycle of a million is still to be seen. */
export function barOf(count: number, most: number): number {
  return most === 0 ? 0 : (100 * Math.log1p(count)) / Math.log1p(most);
}

function Bar({ count, most }: { count: number; most: number }) {
  return (
    <td className="number">
      {count}
      <svg aria-hidden="true">
        <rect width={`${barOf(count, most)}%`} height="100%" />
      </svg>
    </td>
  );
}

/**
 * How long each stage of the cycles took since the start, by classes, and at the longest.
 *
 * @satisfies SWR-CON-036
 */
export function Stages({ stages }: { stages: readonly Stage[] }) {
  const classes = stages[0]?.counts ?? [];
  const most = Math.max(0, ...stages.flatMap(({ counts }) => counts));
  const columns = [
    { number: "Took" },
    ...stages.map(({ name }) => ({ number: name.toLowerCase() })),
  ];
  return (
    <div className="stages">
      <WideTable label="Cycles by the time of each stage" columns={columns}>
        {classes.map((_, index) => (
          <tr key={index}>
            <th scope="row" className="number">
              {className(index, classes.length)}
            </th>
            {stages.map(({ name, counts }) => (
              <Bar key={name} count={counts[index] ?? 0} most={most} />
            ))}
          </tr>
        ))}
        <tr className="stages-worst">
          <th scope="row" className="number">
            Longest
          </th>
          {stages.map(({ name, worst_us }) => (
            <td key={name} className="number">
              {worst_us} µs
            </td>
          ))}
        </tr>
      </WideTable>
      <p className="stages-note">
        Cycles since the start; the bars are logarithmic.{" "}
        {stages
          .map(({ name, says }) => `${name.toLowerCase()}: ${says}`)
          .join(" ")}
      </p>
    </div>
  );
}
