// SPDX-License-Identifier: Apache-2.0
import {
  commands,
  modeButtons,
  type Modes,
  type PoseName,
  type RobotState,
  type Status,
} from "@interface";
import { words } from "../../words/format";
import {
  useCommanding,
  type Commanding,
  type Operation,
} from "../../state/operation";
import { reasonAgainst, usePoses } from "../../state/outlook";
import { Order, OrderNotes, Orders } from "../../parts/Order";

/** A mode whose command says nothing but itself. */
export type ButtonMode = keyof typeof modeButtons;

const ofNeedle: readonly ButtonMode[] = ["ALIGN", "INSERT", "RETRACT"];

export interface NeedleProperties {
  commanding: Commanding;
  outlook: Modes | null;
}

/**
 * A hand was asked for, and the move that entering the workphase has armed stays: the pedal runs that one.
 *
 * @satisfies SWR-CON-755
 */
function whyNotByHand(reason: string, { order, mode }: Status): string {
  return order === "none" || mode.name === "COOPERATE"
    ? reason
    : `${reason} ${words(mode.name)} is armed all the same, and the pedal runs it: command STOP.`;
}

export function isButtonMode(name: string): name is ButtonMode {
  return name in modeButtons;
}

export function ButtonOrder({
  mode,
  status,
  commanding,
  outlook,
}: NeedleProperties & { mode: ButtonMode; status: Status }) {
  const { label, path } = modeButtons[mode];
  const reason = reasonAgainst(outlook, mode);
  const isByHand = mode === "COOPERATE" && reason !== null;
  return (
    <Order
      commanding={commanding}
      path={path}
      refusal={isByHand ? whyNotByHand(reason, status) : reason}
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
          path={commands.POSE.path}
          fields={{ pose }}
          refusal={refusal}
          isTold
        >
          {commands.POSE.label} {words(pose)}
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
        {ofNeedle.map((mode) => (
          <ButtonOrder
            key={mode}
            mode={mode}
            status={robot.status}
            {...properties}
          />
        ))}
      </Orders>
      <Poses {...properties} poses={poses} />
    </>
  );
}
