// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "react";
import { commands, type Axis, type Modes, type RobotState } from "@interface";
import { pathOf } from "../../words/commands";
import {
  useCommanding,
  type Commanding,
  type Operation,
} from "../../state/operation";
import {
  reasonAgainst,
  reasonAgainstAxis,
  type Way,
} from "../../state/outlook";
import { OrderNotes } from "../../parts/Order";
import { sharedReasons, SharedReasons } from "../procedure/Axes";
import { acts, Motor, type BarredWays, type Refusals } from "./Motor";
import "./Motors.css";

const steps = ["0.1", "1", "5", "10"];

/** The last motion that this page has asked for. */
interface Asked {
  axis: string;
  position: number;
}

function refusalsOf(outlook: Modes | null): Refusals {
  const pairs = acts.map((name) => [name, reasonAgainst(outlook, name)]);
  return Object.fromEntries(pairs) as Refusals;
}

function barredWaysOf(outlook: Modes | null, axis: string): BarredWays {
  const against = (way: Way) => reasonAgainstAxis(outlook, "JOG", axis, way);
  return { upwards: against("upwards"), downwards: against("downwards") };
}

/** Each reason once, with all that it stands against. */
function RefusalList({ refusals }: { refusals: Refusals }) {
  const reasons = new Set(acts.map((name) => refusals[name]));
  const barred = (reason: string) =>
    acts
      .filter((name) => refusals[name] === reason)
      .map((name) => commands[name].label);
  return (
    <ul className="motor-refusals">
      {[...reasons]
        .filter((reason) => reason !== null)
        .map((reason) => (
          <li key={reason}>
            {barred(reason).join(", ")}: {reason}
          </li>
        ))}
    </ul>
  );
}

/** A motion that was asked for stands until control has done it or given it up. */
function useAsked(robot: RobotState, commanding: Commanding) {
  const [asked, setAsked] = useState<Asked | null>(null);
  const { order, mode } = robot.status;
  useEffect(() => {
    if (order === "none") {
      setAsked(null);
    }
  }, [order]);
  const send = async ({ name: axis, unit }: Axis, position: number) => {
    setAsked({ axis, position });
    if (!(await commanding.command(pathOf("JOG", axis), { position, unit }))) {
      setAsked(null);
    }
  };
  const isOther = order !== "none" && mode.name !== "JOG";
  return { asked: isOther ? null : asked, send };
}

/**
 * Every axis with its slider. A motion is armed here, and moves while the pedal is pressed.
 *
 * @satisfies SWR-CON-026
 */
export function Motors({
  robot,
  outlook,
  operation,
}: {
  robot: RobotState;
  outlook: Modes | null;
  operation: Operation;
}) {
  const commanding = useCommanding(operation, robot.status.authority);
  const { asked, send } = useAsked(robot, commanding);
  const [step, setStep] = useState("1");
  const { axes } = robot.motors;
  const shared = sharedReasons(axes);
  const refusals = refusalsOf(outlook);
  return (
    <>
      <OrderNotes commanding={commanding} />
      <SharedReasons axes={axes} reasons={shared} />
      <RefusalList refusals={refusals} />
      <label>
        Step, mm or °{" "}
        <select value={step} onChange={(event) => setStep(event.target.value)}>
          {steps.map((one) => (
            <option key={one}>{one}</option>
          ))}
        </select>
      </label>
      <ul className="motors">
        {axes.map((axis) => (
          <Motor
            key={axis.name}
            axis={axis}
            step={Number(step)}
            commanding={commanding}
            refusals={refusals}
            barred={barredWaysOf(outlook, axis.name)}
            shared={shared}
            asked={asked?.axis === axis.name ? asked.position : null}
            send={(position) => void send(axis, position)}
          />
        ))}
      </ul>
    </>
  );
}
