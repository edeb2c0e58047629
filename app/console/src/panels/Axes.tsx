// SPDX-License-Identifier: Apache-2.0
import type { Axis, Named, Permit } from "@interface";
import {
  formatDuration,
  formatNumber,
  formatSpeed,
  formatValue,
  words,
} from "../format";
import type { Level } from "../lamps";
import { Shape } from "../parts/Shape";
import { Track } from "../parts/Track";

const grades: Record<string, string> = {
  fresh: "not homed yet",
  lost: "position lost",
  unverified: "position unverified",
  taken: "taken in place",
};

/**
 * How far the position is trusted, or the leg of homing.
 *
 * @satisfies SWR-REF-012
 */
function gradeOf(axis: Axis): string {
  return grades[axis.reference] ?? words(axis.reference);
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

function reasonWord(name: string): string {
  return words(name).toLowerCase();
}

/** The reasons that stand for every axis; they are told once, above the table. */
export function sharedReasons(axes: readonly Axis[]): Named[] {
  const [first, ...others] = axes.map((axis) => axis.permit.reasons);
  return (first ?? []).filter(({ name }) =>
    others.every((reasons) => reasons.some((reason) => reason.name === name)),
  );
}

export function SharedReasons({ reasons }: { reasons: readonly Named[] }) {
  return (
    <div className="shared-reasons">
      <span>No axis may move:</span>
      <ul>
        {reasons.map((reason) => (
          <li key={reason.name}>{reason.text}</li>
        ))}
      </ul>
    </div>
  );
}

interface PermitCellProperties {
  permit: Permit;
  shared: readonly Named[];
}

/**
 * The axis' own reasons as sentences, the shared ones as words.
 *
 * @satisfies SWR-CON-005
 */
function PermitCell({ permit, shared }: PermitCellProperties) {
  if (permit.allowed) {
    return <span>May move, up to {permit.speed_cap_percent} % speed</span>;
  }
  const isShared = (name: string) =>
    shared.some((reason) => reason.name === name);
  const own = permit.reasons.filter(({ name }) => !isShared(name));
  const named = permit.reasons.filter(({ name }) => isShared(name));
  return (
    <>
      <ul className="reasons">
        {own.map((reason) => (
          <li key={reason.name}>{reason.text}</li>
        ))}
        {named.length > 0 && (
          <li className="reasons-shared">
            {named.map(({ name }) => reasonWord(name)).join(", ")}
          </li>
        )}
      </ul>
      <span className="reasons-since">
        for {formatDuration(permit.since_ms)}
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
      data-axis={axis.name}
      data-level={state.level}
      data-reference={axis.reference}
    >
      <th scope="row">{axis.name}</th>
      <td className="track-cell">
        <div className="track-row">
          <span aria-hidden="true">{formatNumber(axis.minimum, 1)}</span>
          <Track axis={axis} />
          <span aria-hidden="true">{formatNumber(axis.maximum, 1)}</span>
        </div>
      </td>
      <td className="number" data-field="setpoint">
        {formatValue(axis.setpoint, axis.unit)}
      </td>
      <td className="number" data-field="position">
        {formatValue(axis.position, axis.unit)}
      </td>
      <td className="number">{formatSpeed(axis.speed, axis.unit)}</td>
      <td className="axis-state">
        <Shape level={state.level} />
        {state.text}
      </td>
      <td className="axis-permit">
        <PermitCell permit={axis.permit} shared={shared} />
      </td>
    </tr>
  );
}

/**
 * One row for each axis.
 *
 * @satisfies SWR-CON-003
 */
export function Axes({ axes }: { axes: readonly Axis[] }) {
  const shared = sharedReasons(axes);
  return (
    <>
      {shared.length > 0 && <SharedReasons reasons={shared} />}
      <table className="axes">
        <thead>
          <tr>
            <th scope="col">Axis</th>
            <th scope="col" className="track-cell">
              Between its limits
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
            </th>
            <th scope="col" className="number">
              Set-point
            </th>
            <th scope="col" className="number">
              Position
            </th>
            <th scope="col" className="number">
              Speed
            </th>
            <th scope="col">State</th>
            <th scope="col">May it move, and if not, why</th>
          </tr>
        </thead>
        <tbody>
          {axes.map((axis) => (
            <AxisRow key={axis.name} axis={axis} shared={shared} />
          ))}
        </tbody>
      </table>
    </>
  );
}
