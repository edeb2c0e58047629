// SPDX-License-Identifier: Apache-2.0
import { commands, type Force } from "@interface";
import { formatNumber, words } from "../../words/format";
import type { Commanding } from "../../state/operation";
import { Shape } from "../../parts/drawn/Shape";
import { Order, OrderNotes } from "../../parts/Order";
import { WideTable } from "../../parts/WideTable";

const columns = [
  "Channel",
  { number: "Force" },
  { number: "Reading" },
  { number: "Zero" },
  { number: "Noise" },
  "Why not to be believed",
];

function newtons(mn: number, digits: number): string {
  return `${formatNumber(mn / 1000, digits)} N`;
}

function Channel({ force }: { force: Force }) {
  const isBelieved = force.doubts.length === 0;
  const level = isBelieved ? "normal" : "attention";
  return (
    <tr>
      <th scope="row">{words(force.channel).toLowerCase()}</th>
      <td className="number">{newtons(force.force_mn, 2)}</td>
      <td className="number">{force.reading}</td>
      <td className="number">{newtons(force.zero_mn, 2)}</td>
      <td className="number">{newtons(force.noise_mn, 3)}</td>
      <td data-level={level}>
        <Shape level={level} />
        {force.is_zeroing && "It is being zeroed. "}
        {isBelieved
          ? "nothing"
          : force.doubts.map(({ text }) => text).join(" ")}
      </td>
    </tr>
  );
}

/**
 * The channels of the force sensor, and its zeroing.
 *
 * @satisfies SWR-FORCE-578
 */
export function Forces({
  forces,
  commanding,
  refusal,
}: {
  forces: readonly Force[];
  commanding: Commanding;
  refusal: string | null;
}) {
  return (
    <>
      <WideTable label="Channels of the force sensor" columns={columns}>
        {forces.map((force) => (
          <Channel key={force.channel} force={force} />
        ))}
      </WideTable>
      <p>
        A push is positive. A cooperative insertion alone follows the force of
        the hand; no other motion needs a force.
      </p>
      <OrderNotes commanding={commanding} />
      <Order
        commanding={commanding}
        path={commands.ZERO_FORCE.path}
        refusal={refusal}
      >
        {commands.ZERO_FORCE.label}
      </Order>
    </>
  );
}
