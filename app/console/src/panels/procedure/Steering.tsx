// SPDX-License-Identifier: Apache-2.0
import { useId, useState } from "react";
import {
  commands,
  type Modes,
  type SteeringMethod,
  type Targeting,
} from "@interface";
import { formatNumber, readNumbers } from "../../words/format";
import type { Commanding } from "../../state/operation";
import { Order } from "../../parts/Order";
import { reasonAgainst } from "../../state/outlook";

const PER_KM = 1000;
const MOST_DEG = 360;

const methods: Record<SteeringMethod, string> = {
  NONE: "none",
  BIDIRECTIONAL: "to and fro",
  UNIDIRECTIONAL: "on in one direction",
};

function perMetre(curvature_per_km: number): string {
  return `${formatNumber(curvature_per_km / PER_KM, 2)} per m`;
}

/** How the needle is steered, as one text; null of a robot whose needle is not. */
export function steeringText(targeting: Targeting): string | null {
  const { steering_method: method, steering_most_per_km: most } = targeting;
  if (most === 0) return null;
  if (method.name === "NONE") return `none, at most ${perMetre(most)}`;
  const waits = targeting.is_rotation_awaited
    ? ". The needle waits for its rotation."
    : "";
  return (
    `${methods[method.name]}, ${perMetre(targeting.steering_curvature_per_km)} of at most ` +
    `${perMetre(most)} towards ${targeting.steering_direction_deg}°${waits}`
  );
}

/** Curvature and direction in the text; null: they are none, or more than the robot can. */
function readSteering(text: string, most: number): [number, number] | null {
  const numbers = readNumbers(text, 2);
  if (numbers === null) return null;
  const per_km = Math.round((numbers[0] ?? -1) * PER_KM);
  const direction = Math.round(numbers[1] ?? NaN);
  const isIn = per_km >= 0 && per_km <= most && Math.abs(direction) <= MOST_DEG;
  return isIn ? [per_km, direction] : null;
}

/**
 * How the needle is bent by its rotation on its way to the target.
 *
 * @satisfies SWR-STEER-013
 */
export function SteeringOrder({
  targeting,
  outlook,
  commanding,
}: {
  targeting: Targeting;
  outlook: Modes | null;
  commanding: Commanding;
}) {
  const [method, setMethod] = useState(targeting.steering_method.name);
  const [text, setText] = useState(
    `${targeting.steering_curvature_per_km / PER_KM} ${targeting.steering_direction_deg}`,
  );
  const id = useId();
  const most = targeting.steering_most_per_km;
  const read = method === "NONE" ? [0, 0] : readSteering(text, most);
  const missing =
    read === null
      ? `Write a curvature from 0 to ${perMetre(most)} and an angle of the rotation, with a space between them.`
      : null;
  return (
    <div className="orders">
      <label>
        Steering{" "}
        <select
          value={method}
          onChange={(event) => setMethod(event.target.value as SteeringMethod)}
        >
          {Object.entries(methods).map(([name, label]) => (
            <option key={name} value={name}>
              {label}
            </option>
          ))}
        </select>
      </label>
      <label htmlFor={id}>Curvature per m, and direction in degrees</label>
      <input
        id={id}
        size={16}
        value={text}
        disabled={method === "NONE"}
        onChange={(event) => setText(event.target.value)}
      />
      <Order
        commanding={commanding}
        path={commands.STEER.path}
        fields={{
          method,
          curvature_per_km: read?.[0] ?? 0,
          direction_deg: read?.[1] ?? 0,
        }}
        refusal={reasonAgainst(outlook, "STEER") ?? missing}
      >
        {commands.STEER.label}
      </Order>
    </div>
  );
}
