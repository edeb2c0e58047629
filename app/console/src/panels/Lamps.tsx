// SPDX-License-Identifier: Apache-2.0
import { cardLamp, dataLamp, systemLamps } from "../lamps";
import type { Status } from "@interface";
import type { ConsoleView } from "../store";
import { Lamp } from "../parts/Lamp";

export interface LampsProperties {
  view: ConsoleView;
  status: Status;
}

export function SystemLamps({ view, status }: LampsProperties) {
  const lamps = [dataLamp(view.freshness, view.ageMs), ...systemLamps(status)];
  return (
    <ul className="lamps" aria-label="System">
      {lamps.map((lamp) => (
        <Lamp key={lamp.label} {...lamp} />
      ))}
    </ul>
  );
}

export function CardLamps({ status }: { status: Status }) {
  return (
    <ul className="lamps" aria-label="Cards">
      {status.cards.map((card) => (
        <Lamp key={card.slot} {...cardLamp(card)} />
      ))}
    </ul>
  );
}
