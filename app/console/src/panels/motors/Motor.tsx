// SPDX-License-Identifier: Apache-2.0
import { useId, useState } from "react";
import { commands, type Axis, type Named } from "@interface";
import { pathOf, type CommandName } from "../../words/commands";
import {
  formatNumber,
  formatSpeed,
  formatValue,
  readNumbers,
} from "../../words/format";
import { isKnown } from "../../state/trust";
import type { Commanding } from "../../state/operation";
import type { Way } from "../../state/outlook";
import { Order, Orders } from "../../parts/Order";
import { Shape } from "../../parts/drawn/Shape";
import { Slider } from "../../parts/Slider";
import { Twice } from "../../parts/Twice";
import { stateOf } from "../procedure/Axes";

/** Acts on one axis. */
export const acts = [
  "JOG",
  "HOME_AXIS",
  "ENABLE_AXIS",
  "DISABLE_AXIS",
  "CONFIRM_AXIS",
  "SET_HOME",
  "CLEAR_AXIS",
] as const satisfies readonly CommandName[];

export type ActName = (typeof acts)[number];

/** Reasons of refusals; shown once for all axes. */
export type Refusals = Readonly<Record<ActName, string | null>>;

/** Why not this axis, by the way of a jog. */
export type BarredWays = Readonly<Record<Way, string | null>>;

interface MotorProperties {
  axis: Axis;
  step: number;
  commanding: Commanding;
  refusals: Refusals;
  barred: BarredWays;
  shared: readonly Named[];
  asked: number | null;
  send: (position: number) => void;
}

function SwitchLamp({ axis, end }: { axis: Axis; end: "lower" | "upper" }) {
  const isActive =
    end === "lower" ? axis.at_lower_switch : axis.at_upper_switch;
  const limit = end === "lower" ? axis.minimum : axis.maximum;
  return (
    <span className="motor-end" data-level={isActive ? "attention" : "normal"}>
      <span className="number">{formatNumber(limit, 1)}</span>
      <span className="motor-switch">
        <Shape level={isActive ? "attention" : "normal"} />
        <span className="hidden">{end} switch </span>
        {isActive ? "ACTIVE" : "free"}
      </span>
    </span>
  );
}

/** An axis that is not homed has counted its ticks, but from an unknown place. */
function Position({ axis }: { axis: Axis }) {
  const value = formatValue(axis.position, axis.unit);
  return isKnown(axis) ? (
    <dd data-field="position">{value}</dd>
  ) : (
    <dd data-field="position" data-known="false">
      unknown
      <span className="motor-counted">counted {value}</span>
    </dd>
  );
}

function Numbers({ axis }: { axis: Axis }) {
  return (
    <dl className="motor-numbers">
      <div>
        <dt>Set-point</dt>
        <dd data-field="setpoint">
          {isKnown(axis) ? formatValue(axis.setpoint, axis.unit) : "unknown"}
        </dd>
      </div>
      <div>
        <dt>Position</dt>
        <Position axis={axis} />
      </div>
      <div>
        <dt>Speed</dt>
        <dd>{formatSpeed(axis.speed_per_s, axis.unit)}</dd>
      </div>
      <div>
        <dt>Output</dt>
        <dd>{formatNumber(axis.output_percent, 0)} %</dd>
      </div>
    </dl>
  );
}

function BarredJogs({ barred }: Pick<MotorProperties, "barred">) {
  const { upwards, downwards } = barred;
  return upwards === downwards ? (
    upwards !== null && <li>Jog: {upwards}</li>
  ) : (
    <>
      {upwards !== null && <li>Jog upwards: {upwards}</li>}
      {downwards !== null && <li>Jog downwards: {downwards}</li>}
    </>
  );
}

/** May it move, and what stands against it alone. */
function Permit({
  axis,
  shared,
  barred,
}: Pick<MotorProperties, "axis" | "shared" | "barred">) {
  const { allowed, speed_cap_percent: cap, reasons } = axis.permit;
  const own = reasons.filter(({ name }) =>
    shared.every((one) => one.name !== name),
  );
  return (
    <ul className="motor-permit">
      {allowed && <li>May move, up to {cap} % speed</li>}
      {own.map(({ name, text }) => (
        <li key={name}>{text}</li>
      ))}
      <BarredJogs barred={barred} />
    </ul>
  );
}

/** By steps, or to a position. */
function Jog({
  axis,
  step,
  commanding,
  refusals,
  barred,
  send,
}: MotorProperties) {
  const [place, setPlace] = useState("");
  const id = useId();
  const path = pathOf("JOG", axis.name);
  const position = readNumbers(place, 1)?.[0];
  const isReady =
    commanding.obstacle === null &&
    refusals.JOG === null &&
    position !== undefined;
  return (
    <Orders name={`Jog ${axis.name}`}>
      {[-1, 1].map((way) => (
        <Order
          key={way}
          commanding={commanding}
          path={path}
          fields={{ distance: way * step, unit: axis.unit }}
          refusal={refusals.JOG ?? barred[way < 0 ? "downwards" : "upwards"]}
          isTold
        >
          {way < 0 ? "−" : "+"}
          {formatValue(step, axis.unit)}
        </Order>
      ))}
      <label htmlFor={id} className="hidden">
        Position of {axis.name}
      </label>
      <input
        id={id}
        inputMode="decimal"
        size={7}
        value={place}
        onChange={(event) => setPlace(event.target.value)}
      />
      <button
        type="button"
        disabled={!isReady}
        onClick={() => position !== undefined && send(position)}
      >
        Go to
      </button>
    </Orders>
  );
}

function Reference({ axis, commanding, refusals }: MotorProperties) {
  const here = isKnown(axis)
    ? formatValue(axis.position, axis.unit)
    : "a position that is not known";
  return (
    <details>
      <summary>Reference</summary>
      <Orders name={`Reference of ${axis.name}`}>
        <Twice
          question={`Ask for the button at the box: ${axis.name} stands at ${here}?`}
          path={pathOf("CONFIRM_AXIS", axis.name)}
          commanding={commanding}
          refusal={refusals.CONFIRM_AXIS}
        >
          {commands.CONFIRM_AXIS.label}
        </Twice>
        <Twice
          question={`Is home of ${axis.name} where it stands, shown as ${here}?`}
          path={pathOf("SET_HOME", axis.name)}
          commanding={commanding}
          refusal={refusals.SET_HOME}
        >
          {commands.SET_HOME.label}
        </Twice>
        <Twice
          question={`Forget the position of ${axis.name}?`}
          path={pathOf("CLEAR_AXIS", axis.name)}
          commanding={commanding}
          refusal={refusals.CLEAR_AXIS}
        >
          {commands.CLEAR_AXIS.label}
        </Twice>
      </Orders>
    </details>
  );
}

function Acts({ axis, commanding, refusals }: MotorProperties) {
  const isEnabled = axis.power === "enabled";
  const power = isEnabled ? "DISABLE_AXIS" : "ENABLE_AXIS";
  return (
    <Orders name={`Power and homing of ${axis.name}`}>
      <Order
        commanding={commanding}
        path={pathOf("HOME_AXIS", axis.name)}
        refusal={refusals.HOME_AXIS}
        isTold
      >
        {commands.HOME_AXIS.label} {axis.name}
      </Order>
      <Order
        commanding={commanding}
        path={pathOf(power, axis.name)}
        refusal={refusals[power]}
        isTold
      >
        {commands[power].label} {axis.name}
      </Order>
    </Orders>
  );
}

/** One axis with its slider, its numbers and its orders. */
export function Motor(properties: MotorProperties) {
  const { axis, step, commanding, refusals, barred, shared, asked, send } =
    properties;
  const state = stateOf(axis);
  const id = useId();
  return (
    <li
      className="motor"
      aria-labelledby={id}
      data-axis={axis.name}
      data-level={state.level}
      data-reference={axis.reference}
    >
      <div className="motor-head">
        <h3 id={id}>{axis.name}</h3>
        <span className="axis-state">
          <Shape level={state.level} />
          {state.text}
        </span>
        <Permit axis={axis} shared={shared} barred={barred} />
      </div>
      <div className="motor-way">
        <SwitchLamp axis={axis} end="lower" />
        <Slider
          axis={axis}
          asked={asked}
          step={step}
          isLocked={
            commanding.obstacle !== null ||
            refusals.JOG !== null ||
            !isKnown(axis)
          }
          onSend={send}
        />
        <SwitchLamp axis={axis} end="upper" />
      </div>
      <Numbers axis={axis} />
      <div className="motor-orders">
        <Jog {...properties} />
        <Acts {...properties} />
        <Reference {...properties} />
      </div>
    </li>
  );
}
