// SPDX-License-Identifier: Apache-2.0
import type { Modes, Path, PoseName } from "@interface";
import { words } from "../format";
import type { Commanding } from "../operation";
import { reasonAgainst } from "../outlook";
import { Order, Orders } from "../parts/Order";

const motions = {
  ALIGN: ["Align", "/api/v1/align"],
  INSERT: ["Insert", "/api/v1/needle/insert"],
  RETRACT: ["Retract needle", "/api/v1/needle/retract"],
} as const satisfies Record<string, readonly [string, Path]>;

export type NeedleMode = keyof typeof motions;

export interface NeedleProperties {
  commanding: Commanding;
  outlook: Modes | null;
}

export function isNeedleMode(name: string): name is NeedleMode {
  return name in motions;
}

export function NeedleOrder({
  mode,
  commanding,
  outlook,
}: NeedleProperties & { mode: NeedleMode }) {
  const [label, path] = motions[mode];
  return (
    <Order
      commanding={commanding}
      path={path}
      refusal={reasonAgainst(outlook, mode)}
    >
      {label}
    </Order>
  );
}

export function Poses({
  commanding,
  outlook,
  poses,
}: NeedleProperties & { poses: readonly PoseName[] }) {
  const refusal = reasonAgainst(outlook, "POSE");
  return (
    <Orders name="Poses" refusal={refusal}>
      {poses.map((pose) => (
        <Order
          key={pose}
          commanding={commanding}
          path="/api/v1/pose"
          fields={{ pose }}
          refusal={refusal}
          isTold
        >
          Pose {words(pose)}
        </Order>
      ))}
    </Orders>
  );
}

/** What the whole robot does. */
export function Whole({
  poses,
  ...properties
}: NeedleProperties & { poses: readonly PoseName[] }) {
  return (
    <>
      <Orders name="Needle">
        {Object.keys(motions)
          .filter(isNeedleMode)
          .map((mode) => (
            <NeedleOrder key={mode} mode={mode} {...properties} />
          ))}
      </Orders>
      <Poses {...properties} poses={poses} />
    </>
  );
}
