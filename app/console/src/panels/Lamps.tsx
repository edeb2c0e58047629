// SPDX-License-Identifier: Apache-2.0
import { dataLamp, systemLamps } from "../lamps";
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
