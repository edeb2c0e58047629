// SPDX-License-Identifier: Apache-2.0
import { useId, useState } from "react";
import type { Axis, Modes, Path, RobotState } from "@interface";
import { formatValue, readNumbers } from "../format";
import { useCommanding, type Commanding, type Operation } from "../operation";
import { reasonAgainst, usePoses } from "../outlook";
import { Order, OrderNotes, Orders } from "../parts/Order";
import { Whole } from "./Needle";

const steps = ["0.1", "1", "5", "10"];
const MANUAL_ONLY = "Only in MANUAL.";

interface AxisOrdersProperties {
  axis: Axis;
  commanding: Commanding;
  outlook: Modes | null;
}

/** By steps, or to a position. */
function Jog({ axis, commanding, outlook }: AxisOrdersProperties) {
  const [step, setStep] = useState("1");
  const [place, setPlace] = useState("");
  const id = useId();
  const path: Path = `/api/v1/motors/${axis.name}/jog`;
  const refusal = reasonAgainst(outlook, "JOG");
  const position = readNumbers(place, 1)?.[0];
  return (
    <Orders name="Jog" refusal={refusal}>
      <label>
        Step{" "}
        <select value={step} onChange={(event) => setStep(event.target.value)}>
          {steps.map((one) => (
            <option key={one}>{one}</option>
          ))}
        </select>
      </label>
      {[-1, 1].map((way) => (
        <Order
          key={way}
          commanding={commanding}
          path={path}
          fields={{ distance: way * Number(step) }}
          refusal={refusal}
          isTold
        >
          {way < 0 ? "−" : "+"}
          {formatValue(Number(step), axis.unit)}
        </Order>
      ))}
      <label htmlFor={id}>Position</label>
      <input
        id={id}
        inputMode="decimal"
        size={8}
        value={place}
        onChange={(event) => setPlace(event.target.value)}
      />
      <Order
        commanding={commanding}
        path={path}
        fields={{ position }}
        refusal={refusal ?? (position === undefined ? "Write a number." : null)}
        isTold={refusal !== null}
      >
        Go to
      </Order>
    </Orders>
  );
}

/** What changes a position without a motion is asked twice. */
function Twice({
  question,
  path,
  commanding,
  refusal,
  children,
}: {
  question: string;
  path: Path;
  commanding: Commanding;
  refusal: string | null;
  children: string;
}) {
  const [isAsked, setIsAsked] = useState(false);
  if (!isAsked) {
    return (
      <span className="order">
        <button
          type="button"
          disabled={commanding.obstacle !== null || refusal !== null}
          title={refusal ?? undefined}
          onClick={() => setIsAsked(true)}
        >
          {children}…
        </button>
      </span>
    );
  }
  return (
    <span className="order order-asked" role="group" aria-label={question}>
      {question}{" "}
      <button
        type="button"
        onClick={() => {
          setIsAsked(false);
          void commanding.command(path);
        }}
      >
        {children}
      </button>{" "}
      <button type="button" autoFocus onClick={() => setIsAsked(false)}>
        Cancel
      </button>
    </span>
  );
}

function Reference({
  axis,
  commanding,
  outlook,
  isManual,
}: AxisOrdersProperties & { isManual: boolean }) {
  const path = `/api/v1/motors/${axis.name}` as const;
  const manual = isManual ? null : MANUAL_ONLY;
  const engineers =
    manual ??
    (commanding.isEngineer ? null : "Engineers set home and clear positions.");
  const here = formatValue(axis.position, axis.unit);
  return (
    <Orders name="Reference" refusal={manual ?? engineers}>
      <Order
        commanding={commanding}
        path={`${path}/home`}
        refusal={reasonAgainst(outlook, "HOME_AXIS")}
        isTold={manual !== null}
      >
        Home {axis.name}
      </Order>
      <Twice
        question={`Ask for the button at the box: ${axis.name} stands at ${here}?`}
        path={`${path}/confirm`}
        commanding={commanding}
        refusal={null}
      >
        Confirm position
      </Twice>
      <Order
        commanding={commanding}
        path={`${path}/${axis.power === "enabled" ? "disable" : "enable"}`}
        refusal={manual}
        isTold
      >
        {axis.power === "enabled" ? "Disable" : "Enable"} {axis.name}
      </Order>
      <Twice
        question={`Is home of ${axis.name} where it stands, shown as ${here}?`}
        path={`${path}/set-home`}
        commanding={commanding}
        refusal={engineers}
      >
        Set home
      </Twice>
      <Twice
        question={`Forget the position of ${axis.name}?`}
        path={`${path}/clear`}
        commanding={commanding}
        refusal={engineers}
      >
        Clear position
      </Twice>
    </Orders>
  );
}

/**
 * The motions of one axis and of the robot. Each is armed here, and moves while the pedal is pressed.
 *
 * @satisfies SWR-CON-017
 */
export function Motion({
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
  const { axes } = robot.motors;
  const [name, setName] = useState<string | null>(null);
  const axis = axes.find((one) => one.name === name) ?? axes[0];
  if (axis === undefined) {
    return null;
  }
  const properties = { axis, commanding, outlook };
  return (
    <>
      <OrderNotes commanding={commanding} />
      <Whole commanding={commanding} outlook={outlook} poses={poses} />
      <label>
        Axis{" "}
        <select
          value={axis.name}
          onChange={(event) => setName(event.target.value)}
        >
          {axes.map((one) => (
            <option key={one.name}>{one.name}</option>
          ))}
        </select>
      </label>
      <Jog key={`jog ${axis.name}`} {...properties} />
      <Reference
        key={axis.name}
        {...properties}
        isManual={robot.status.workphase.name === "MANUAL"}
      />
    </>
  );
}
