// SPDX-License-Identifier: Apache-2.0
import type { Robot } from "@interface";
import { words } from "../words/format";
import { WideTable } from "../parts/WideTable";
import type { Frame } from "./recording";

/**
 * The frame that left to each card.
 *
 * @satisfies SWR-REPLAY-016
 */
export function Frames({
  frames,
  robot,
}: {
  frames: readonly (Frame | null)[];
  robot: Robot;
}) {
  const sent = frames.flatMap((frame, slot) =>
    frame === null ? [] : [{ slot, frame }],
  );
  const names = Object.keys(sent[0]?.frame ?? {});
  if (sent.length === 0) {
    return <p>Nothing left to any card.</p>;
  }
  const axisOf = (slot: number) =>
    robot.axes.find((axis) => axis.slot === slot)?.name ?? "no axis";
  return (
    <WideTable
      label="Frames by slot"
      columns={[
        "Field",
        ...sent.map(({ slot }) => ({ number: `${slot}, ${axisOf(slot)}` })),
      ]}
    >
      {names.map((name) => (
        <tr key={name} data-field={name}>
          <th scope="row">{words(name)}</th>
          {sent.map(({ slot, frame }) => (
            <td key={slot} className="number">
              {frame[name]}
            </td>
          ))}
        </tr>
      ))}
    </WideTable>
  );
}
