// SPDX-License-Identifier: Apache-2.0
import type { Axis } from "@interface";
import { formatValue } from "../format";

/** Where `value` lies between the soft limits, 0 to 100. */
export function percentOf(axis: Axis, value: number): number {
  const range = axis.maximum - axis.minimum;
  const percent = range > 0 ? ((value - axis.minimum) / range) * 100 : 0;
  return Math.min(100, Math.max(0, percent));
}

function describe(axis: Axis): string {
  const value = (number: number) => formatValue(number, axis.unit);
  return (
    `${axis.name}: set-point ${value(axis.setpoint)}, position ${value(axis.position)}, ` +
    `limits ${value(axis.minimum)} to ${value(axis.maximum)}`
  );
}

/**
 * The axis between its soft limits: circle for the set-point, diamond for the position, a short bar for the end of
 * the armed motion.
 */
export function Track({ axis }: { axis: Axis }) {
  const target = `${percentOf(axis, axis.target)}%`;
  return (
    <svg className="track" role="img" aria-label={describe(axis)}>
      <line className="track-line" x1="0" x2="100%" y1="50%" y2="50%" />
      <line className="track-limit" x1="0" x2="0" y1="20%" y2="80%" />
      <line className="track-limit" x1="100%" x2="100%" y1="20%" y2="80%" />
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
        cx={`${percentOf(axis, axis.setpoint)}%`}
        cy="50%"
        r="8"
      />
      <svg
        className="track-position"
        x={`${percentOf(axis, axis.position)}%`}
        y="50%"
        overflow="visible"
      >
        <path d="M0-6L6 0 0 6-6 0z" />
      </svg>
    </svg>
  );
}
