// SPDX-License-Identifier: Apache-2.0
import type { Card } from "@interface";
import { words } from "../../words/format";
import { cardLamp } from "../../state/lamps";
import { Shape } from "../../parts/drawn/Shape";
import { WideTable } from "../../parts/WideTable";

const columns = [
  { number: "Slot" },
  "Axis",
  "Card",
  "Link",
  { number: "Last report" },
  { number: "Heartbeat" },
  { number: "Refused" },
  "Converters",
  "Faults",
];

function Found({ card }: { card: Card }) {
  const { level, word } = cardLamp(card);
  const isHeard = card.type !== "none";
  return (
    <>
      <td>{card.axis ?? "none"}</td>
      <td>{isHeard ? words(card.type) : "not heard yet"}</td>
      <td data-level={level}>
        <Shape level={level} />
        {word.toLowerCase()}
      </td>
      <td className="number">{isHeard ? `${card.age_cycles} ms ago` : ""}</td>
      <td className="number">{isHeard ? card.heartbeat : ""}</td>
      <td className="number">{card.frame_errors}</td>
      <td className="number cards-converters">{card.converters.join(" ")}</td>
      <td data-level={card.faults.length === 0 ? "normal" : "fault"}>
        {card.faults.length === 0 ? "none" : card.faults.join(", ")}
      </td>
    </>
  );
}

function Slot({ slot, card }: { slot: number; card: Card | undefined }) {
  return (
    <tr>
      <th scope="row" className="number">
        {slot}
      </th>
      {card === undefined ? (
        <td colSpan={columns.length - 1}>
          <Shape level="unknown" />
          nothing found
        </td>
      ) : (
        <Found card={card} />
      )}
    </tr>
  );
}

/**
 * Each slot of the control box, with the card that was found there.
 *
 * @satisfies SWR-CON-036
 */
export function Cards({
  cards,
  slots,
}: {
  cards: readonly Card[];
  slots: number;
}) {
  return (
    <WideTable label="Slots of the control box" columns={columns}>
      {Array.from({ length: slots }, (_, slot) => (
        <Slot
          key={slot}
          slot={slot}
          card={cards.find((card) => card.slot === slot)}
        />
      ))}
    </WideTable>
  );
}
