// SPDX-License-Identifier: Apache-2.0
import { dataLamp, lampsOf } from "../../state/lamps";
import type { Status } from "@interface";
import type { ConsoleView } from "../../state/store";
import { Lamp } from "../../parts/drawn/Lamp";

export interface LampsProperties {
  view: ConsoleView;
  status: Status;
}

/** @satisfies SWR-CON-061 */
export function SystemLamps({ view, status }: LampsProperties) {
  const { freshness, ageMs } = view;
  const lamps = [dataLamp(freshness, ageMs), ...lampsOf(status, freshness)];
  return (
    <ul className="lamps" aria-label="System">
      {lamps.map((lamp) => (
        <Lamp key={lamp.label} {...lamp} />
      ))}
    </ul>
  );
}
