// SPDX-License-Identifier: Apache-2.0
// Does the robot move, may it, and if not, why: one word for it, to be read from where the robot stands.
import type { Alarm, Axis, Named, PermitReason, RobotState } from "@interface";
import type { ConsoleView } from "../state/store";

export type SignKind =
  | "moving"
  | "may"
  | "armed"
  | "stands"
  | "estop"
  | "lost"
  | "fault"
  | "stale"
  | "absent";

export interface Sign {
  kind: SignKind;
  word: string;
  /** Which axes, or why not. */
  says: string;
}

const words: Readonly<Record<SignKind, string>> = {
  moving: "MOVING",
  may: "MAY MOVE",
  armed: "ARMED",
  stands: "STANDS",
  estop: "E-STOP",
  lost: "CARD LOST",
  fault: "FAULT",
  stale: "DATA STALE",
  absent: "NO DATA",
};

/** The sign of each reason that keeps a robot from moving. The most pressing first, as the server reports them. */
const kinds: Readonly<Record<PermitReason, SignKind>> = {
  MEMORY: "fault",
  INPUTS_UNREAD: "fault",
  ESTOP_PULLED: "estop",
  LINK_LOST: "lost",
  CARDS_UNPROTECTED: "stands",
  LOOP_STOPPED: "fault",
  PEDAL_FAULT: "fault",
  AXIS_FAULT: "fault",
  FORCE_DOUBTFUL: "fault",
  ESTOP_LATCHED: "stands",
  SCANNER_ACTIVE: "stands",
  AXIS_DISABLED: "stands",
  NOTHING_ARMED: "stands",
  NOT_HOMED: "stands",
  NEEDLE_IN: "stands",
  LIMIT_SWITCH: "stands",
  SOFT_LIMIT: "stands",
  COUPLED_LIMIT: "stands",
  AT_DEPTH: "stands",
  ROTATION_LAGS: "stands",
  PEDAL_UNPROVEN: "stands",
  PEDAL_RELEASED: "armed",
  HAND_UNPROVEN: "armed",
  HAND_OFF: "armed",
};

const ranks = Object.keys(kinds);

function rankOf({ name }: Named): number {
  return ranks.indexOf(name);
}

/** Nothing but the pedal is missing, or the hand that is to push. */
function isArmed({ permit: { reasons } }: Axis): boolean {
  return reasons.every(({ name }) => kinds[name] === "armed");
}

function mostPressing(axes: readonly Axis[]): Named<PermitReason> | undefined {
  return axes
    .flatMap(({ permit }) => permit.reasons)
    .sort((one, other) => rankOf(one) - rankOf(other))[0];
}

function makeSign(kind: SignKind, says: string): Sign {
  return { kind, word: words[kind], says };
}

function namesOf(axes: readonly Axis[]): string {
  return axes.map(({ name }) => name).join(", ");
}

/** An alarm that is over stands until START_UP, and is no fault any more. */
function isOver(alarms: readonly Alarm[], reason: PermitReason): boolean {
  const own = alarms.filter((alarm) => alarm.reason === reason);
  return own.length > 0 && own.every(({ is_over }) => is_over);
}

function signOfStanding(axes: readonly Axis[], alarms: readonly Alarm[]): Sign {
  const reason = mostPressing(axes);
  const isFault = reason !== undefined && !isOver(alarms, reason.name);
  return makeSign(
    isFault ? (kinds[reason.name] ?? "stands") : "stands",
    reason?.text ?? "",
  );
}

function signOfRobot({ status, motors: { axes } }: RobotState): Sign {
  const driven = axes.filter((axis) => axis.is_driven);
  if (driven.length > 0) {
    return makeSign("moving", namesOf(driven));
  }
  const free = axes.filter(({ permit }) => permit.allowed);
  if (free.length > 0) {
    return makeSign("may", namesOf(free));
  }
  const armed = axes.filter(isArmed);
  return armed.length > 0
    ? makeSign("armed", mostPressing(armed)?.text ?? "")
    : signOfStanding(axes, status.alarms);
}

/**
 * @satisfies SWR-CON-020
 * @satisfies SWR-CON-150
 */
export function signOf(view: ConsoleView): Sign {
  if (view.robot === null) {
    return makeSign("absent", "");
  }
  return view.freshness === "stale"
    ? makeSign("stale", "")
    : signOfRobot(view.robot);
}
