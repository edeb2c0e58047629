// SPDX-License-Identifier: Apache-2.0
import type { Modes, Path, PoseName, RobotState } from "@interface";
import { words } from "../../words/format";
import { useCommanding, type Commanding, type Operation } from "../../state/operation";
import { reasonAgainst, usePoses } from "../../state/outlook";
import { Order, OrderNotes, Orders } from "../../parts/Order";

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

/**
 * The motions and poses of the whole robot. Each is armed here, and moves while the pedal is pressed.
 *
 * @satisfies SWR-CON-017
 */
export function Needle({
  robot,
  outlook,
  operation,
}: {
  robot: RobotState;
  outlook: Modes | null;
  operation: Operation;
}) {
  const commanding = useCommanding(operation, robot.status.authority);
  const poses = usePoses(operation.page, robot.status.boot_id);
  const properties = { commanding, outlook };
  return (
    <>
      <OrderNotes commanding={commanding} />
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
