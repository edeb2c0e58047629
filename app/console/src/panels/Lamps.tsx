// SPDX-License-Identifier: Apache-2.0
import { cardLamp, dataLamp, systemLamps } from "../lamps";
import type { RobotState } from "@interface";
import type { ConsoleView } from "../store";
import { Lamp } from "../parts/Lamp";

export interface LampsProperties {
  view: ConsoleView;
  robot: RobotState;
}

export function Lamps({ view, robot }: LampsProperties) {
  const { status } = robot;
  const lamps = [dataLamp(view.freshness, view.ageMs), ...systemLamps(status)];
  return (
    <>
      <ul className="lamps" aria-label="System">
        {lamps.map((lamp) => (
          <Lamp key={lamp.label} {...lamp} />
        ))}
      </ul>
      <ul className="lamps" aria-label="Cards">
        {status.cards.map((card) => (
          <Lamp key={card.slot} {...cardLamp(card)} />
        ))}
      </ul>
    </>
  );
}
