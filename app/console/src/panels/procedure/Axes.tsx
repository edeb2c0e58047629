// SPDX-License-Identifier: Apache-2.0
import type { Axis, Named, Permit } from "@interface";
import {
  formatDuration,
  formatNumber,
  formatSpeed,
  formatValue,
} from "../../words/format";
import type { Level } from "../../state/lamps";
import { Shape } from "../../parts/drawn/Shape";
import { Track } from "../../parts/drawn/Track";
import { trustOf } from "../../state/trust";
import "./Axes.css";

const grades: Readonly<Record<string, string>> = {
  fresh: "not homed yet",
  lost: "position lost",
  unverified: "position unverified",
  taken: "taken in place",
  leave: "homing, leaves its switch",
  approach: "homing, to its switch",
  back_off: "homing, backs off",
  latch: "homing, at its switch",
};

/**
 * How far the position is trusted, or the leg of homing.
 *
 * @satisfies SWR-REF-012
 */
function gradeOf(axis: Axis): string {
  return grades[axis.reference] ?? axis.reference;
}

export function stateOf(axis: Axis): { level: Level; text: string } {
  if (axis.power === "fault") {
    const cause = axis.stall === "stalled" ? "stalled" : "faulty";
    return { level: "fault", text: `${cause}, ${gradeOf(axis)}` };
  }
  if (axis.power !== "enabled") {
    return { level: "unknown", text: `disabled, ${gradeOf(axis)}` };
  }
  const text = `enabled, ${gradeOf(axis)}`;
  return { level: axis.is_driven ? "active" : "normal", text };
}

/** The reasons that stand for every axis; they are shown once, above the table. */
export function sharedReasons(axes: readonly Axis[]): Named[] {
  const [first, ...others] = axes.map((axis) => axis.permit.reasons);
  return (first ?? []).filter(({ name }) =>
    others.every((reasons) => reasons.some((reason) => reason.name === name)),
  );
}

/** It keeps its place when there is nothing to say, so that the rows keep theirs. */
export function SharedReasons({
  axes,
  reasons,
}: {
  axes: readonly Axis[];
  reasons: readonly Named[];
}) {
  const free = axes.filter(({ permit }) => permit.allowed).length;
  const some = free === axes.length ? "All axes" : "Some axes";
  return (
    <div className="shared-reasons">
      {reasons.length === 0 ? (
        <span>
          {free === 0
            ? "Each axis has a reason of its own."
            : `${some} may move.`}
        </span>
      ) : (
        <>
          <span>No axis may move:</span>
          <ul>
            {reasons.map((reason) => (
              <li key={reason.name}>{reason.text}</li>
            ))}
          </ul>
        </>
      )}
    </div>
  );
}

interface PermitCellProperties {
  permit: Permit;
  shared: readonly Named[];
}

/** Those that hold for every axis stand above the table; without another the most pressing of them is named. */
function OwnReasons({ permit, shared }: PermitCellProperties) {
  const own = permit.reasons.filter(
    ({ name }) => !shared.some((reason) => reason.name === name),
  );
  if (own.length === 0) {
    return `As for every axis: ${shared[0]?.text ?? ""}`;
  }
  return (
    <ul className="reasons">
      {own.map((reason) => (
        <li key={reason.name}>{reason.text}</li>
      ))}
    </ul>
  );
}

/** @satisfies SWR-CON-005 */
function PermitCell({ permit, shared }: PermitCellProperties) {
  if (permit.allowed) {
    return <>May move, up to {permit.speed_cap_percent} % speed</>;
  }
  return (
    <>
      <OwnReasons permit={permit} shared={shared} />{" "}
      <span className="reasons-since">
        for {formatDuration(permit.since_ms)}
      </span>
    </>
  );
}

/**
 * A number that is not to be believed stands small beneath the word for that.
 *
 * @satisfies SWR-CON-021
 */
function Place({ axis, value }: { axis: Axis; value: number }) {
  const { word, mark } = trustOf(axis);
  const text = formatValue(value, axis.unit);
  if (word === null) {
    return <>{text}</>;
  }
  return (
    <>
      <span className="place-word">{word}</span>{" "}
      <span className="place-number">
        {mark} {text}
      </span>
    </>
  );
}

interface AxisRowProperties {
  axis: Axis;
  shared: readonly Named[];
}

function AxisRow({ axis, shared }: AxisRowProperties) {
  const state = stateOf(axis);
  return (
    <tr
      role="row"
      data-axis={axis.name}
      data-level={state.level}
      data-reference={axis.reference}
    >
      <th role="rowheader" scope="row">
        {axis.name}
      </th>
      <td role="cell" className="track-cell">
        <div className="track-row">
          <span aria-hidden="true">{formatNumber(axis.minimum, 1)}</span>
          <Track axis={axis} />
          <span aria-hidden="true">{formatNumber(axis.maximum, 1)}</span>
        </div>
      </td>
      <td
        role="cell"
        className="number"
        data-field="setpoint"
        data-label="Set-point"
      >
        {trustOf(axis).isPlaced ? formatValue(axis.setpoint, axis.unit) : "–"}
      </td>
      <td
        role="cell"
        className="number"
        data-field="position"
        data-label="Position"
      >
        <Place axis={axis} value={axis.position} />
      </td>
      <td role="cell" className="number" data-label="Speed">
        {formatSpeed(axis.speed_per_s, axis.unit)}
      </td>
      <td role="cell" className="axis-state">
        <Shape level={state.level} />
        {state.text}
      </td>
      <td role="cell" className="axis-permit">
        <PermitCell permit={axis.permit} shared={shared} />
      </td>
    </tr>
  );
}

function Legend() {
  return (
    <span className="legend">
      <svg viewBox="-10 -10 20 20" aria-hidden="true">
        <circle className="track-setpoint" r="8" />
      </svg>
      set-point
      <svg viewBox="-10 -10 20 20" aria-hidden="true">
        <path className="track-position" d="M0-8L8 0 0 8-8 0z" />
      </svg>
      position
    </span>
  );
}

function Head() {
  return (
    <thead role="rowgroup">
      <tr role="row">
        <th role="columnheader">Axis</th>
        <th role="columnheader" className="track-cell">
          Between its limits
          <Legend />
        </th>
        <th role="columnheader" className="number">
          Set-point
        </th>
        <th role="columnheader" className="number">
          Position
        </th>
        <th role="columnheader" className="number">
          Speed
        </th>
        <th role="columnheader">State</th>
        <th role="columnheader">May it move, and if not, why</th>
      </tr>
    </thead>
  );
}

/**
 * One row for each axis. On a small screen the rows are cards; the roles keep them a table to those who hear it.
 *
 * @satisfies SWR-CON-003
 */
export function Axes({ axes }: { axes: readonly Axis[] }) {
  const shared = sharedReasons(axes);
  const isCounted = axes.some((axis) => !trustOf(axis).isPlaced);
  return (
    <>
      <SharedReasons axes={axes} reasons={shared} />
      <table role="table" className="axes">
        <Head />
        <tbody role="rowgroup">
          {axes.map((axis) => (
            <AxisRow key={axis.name} axis={axis} shared={shared} />
          ))}
        </tbody>
      </table>
      <p className="axes-note">
        {isCounted &&
          "counted: by the encoder alone. Where the axis truly stands, nobody knows before it is homed or confirmed."}
      </p>
    </>
  );
}
