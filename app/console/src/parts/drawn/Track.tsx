// SPDX-License-Identifier: Apache-2.0
import type { Axis } from "@interface";
import { formatValue } from "../../words/format";
import { trustOf } from "../../state/trust";
import "./Track.css";

/** Room beyond each limit, in percent of the drawing. */
const ROOM = 8;

/** Where `value` lies between the soft limits: 0 to 100, and as far outside as it is. */
export function percentOf(axis: Axis, value: number): number {
  const range = axis.maximum - axis.minimum;
  return range > 0 ? ((value - axis.minimum) / range) * 100 : 0;
}

/** Percent of the drawing. A value that is too far outside stands at its end, with an arrow. */
function placeOf(axis: Axis, value: number): { x: number; beyond: number } {
  const x = ROOM + (percentOf(axis, value) * (100 - 2 * ROOM)) / 100;
  const shown = Math.min(100, Math.max(0, x));
  return { x: shown, beyond: Math.sign(x - shown) };
}

function describe(axis: Axis): string {
  const value = (number: number) => formatValue(number, axis.unit);
  const limits = `limits ${value(axis.minimum)} to ${value(axis.maximum)}`;
  const { isPlaced, word } = trustOf(axis);
  if (!isPlaced) {
    return `${axis.name}: position ${word}, ${limits}`;
  }
  const doubt = word === null ? "" : ` (${word})`;
  return `${axis.name}: set-point ${value(axis.setpoint)}, position ${value(axis.position)}${doubt}, ${limits}`;
}

function Mark({ axis }: { axis: Axis }) {
  const { x, beyond } = placeOf(axis, axis.position);
  const outline = beyond === 0 ? "M0-6L6 0 0 6-6 0z" : "M0-7L9 0 0 7z";
  return (
    <svg
      className="track-position"
      data-beyond={beyond}
      x={`${x}%`}
      y="50%"
      overflow="visible"
    >
      <path d={outline} transform={beyond < 0 ? "scale(-1 1)" : undefined} />
    </svg>
  );
}

function Marks({ axis }: { axis: Axis }) {
  const target = `${placeOf(axis, axis.target).x}%`;
  return (
    <>
      {axis.target_ticks !== axis.position_ticks && (
        <line
          className="track-target"
          x1={target}
          x2={target}
          y1="15%"
          y2="85%"
        />
      )}
      <circle
        className="track-setpoint"
        cx={`${placeOf(axis, axis.setpoint).x}%`}
        cy="50%"
        r="8"
      />
      <Mark axis={axis} />
    </>
  );
}

/**
 * The axis between its soft limits: circle for the set-point, diamond for the position, a short bar for the end of
 * the armed motion. Its position is not drawn while it is unknown.
 *
 * @satisfies SWR-CON-021
 */
export function Track({ axis }: { axis: Axis }) {
  const [lower, upper] = [`${ROOM}%`, `${100 - ROOM}%`];
  return (
    <svg className="track" role="img" aria-label={describe(axis)}>
      <line className="track-line" x1={lower} x2={upper} y1="50%" y2="50%" />
      <line className="track-limit" x1={lower} x2={lower} y1="20%" y2="80%" />
      <line className="track-limit" x1={upper} x2={upper} y1="20%" y2="80%" />
      {trustOf(axis).isPlaced ? (
        <Marks axis={axis} />
      ) : (
        <text className="track-unknown" x="50%" y="50%" dy="0.35em">
          ?
        </text>
      )}
    </svg>
  );
}
