// SPDX-License-Identifier: Apache-2.0
import type { Card } from "@interface";
import { formatNumber } from "../../words/format";
import { Shape } from "../../parts/drawn/Shape";
import { WideTable } from "../../parts/WideTable";

const columns = [
  { number: "Slot" },
  "Axis",
  { number: "Driver" },
  { number: "Motor" },
  { number: "Supply" },
  { number: "Current" },
  { number: "Damaged commands" },
  { number: "Out of order" },
  { number: "Watchdog trips" },
  { number: "Damaged reports" },
  { number: "Disordered reports" },
  { number: "Missed reports" },
  "Trouble",
];

function degrees(tenths: number): string {
  return `${formatNumber(tenths / 10, 1)} °C`;
}

/** It was lost, and may be heard again before START_UP takes it back. */
function isSilent({ link, age_cycles }: Card): boolean {
  return link === "lost" && age_cycles !== 0;
}

function lossOf(card: Card): string[] {
  if (card.link !== "lost") return [];
  return [isSilent(card) ? "It is lost." : "It was lost, and answers."];
}

/** The measurements of a card; empty while it is silent, as they are old then. */
function Measured({ card }: { card: Card }) {
  const cells = isSilent(card)
    ? ["", "", "", ""]
    : [
        degrees(card.driver_temperature_dc),
        degrees(card.motor_temperature_dc),
        `${formatNumber(card.supply_mv / 1000, 1)} V`,
        `${String(card.current_ma)} mA`,
      ];
  return cells.map((cell, column) => (
    <td key={column} className="number">
      {cell}
    </td>
  ));
}

function Health({ card }: { card: Card }) {
  const troubles = [...lossOf(card), ...card.troubles.map(({ text }) => text)];
  const level = troubles.length === 0 ? "normal" : "attention";
  return (
    <tr>
      <th scope="row" className="number">
        {card.slot}
      </th>
      <td>{card.axis ?? "none"}</td>
      <Measured card={card} />
      <td className="number">{card.commands_damaged}</td>
      <td className="number">{card.commands_out_of_order}</td>
      <td className="number">{card.watchdog_trips}</td>
      <td className="number">{card.frame_errors - card.frames_out_of_order}</td>
      <td className="number">{card.frames_out_of_order}</td>
      <td className="number">{card.frames_missed}</td>
      <td data-level={level}>
        <Shape level={level} />
        {troubles.length === 0 ? "nothing" : troubles.join(" ")}
      </td>
    </tr>
  );
}

/**
 * The measurements and counts of each card that was heard.
 *
 * @satisfies SWR-CARD-014
 * @satisfies SWR-LINK-041
 * @satisfies SWR-CON-180
 */
export function CardHealth({ cards }: { cards: readonly Card[] }) {
  return (
    <WideTable label="Health of the cards" columns={columns}>
      {[...cards]
        .filter(({ type }) => type !== "none")
        .sort((one, other) => one.slot - other.slot)
        .map((card) => (
          <Health key={card.slot} card={card} />
        ))}
    </WideTable>
  );
}
