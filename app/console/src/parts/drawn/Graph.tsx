// SPDX-License-Identifier: Apache-2.0
import "./Graph.css";

export type GraphPoint = readonly [x: number, y: number];

export interface Curve {
  name: string;
  /** Its look: each has strokes of its own. */
  kind: "first" | "second" | "third";
  points: readonly GraphPoint[];
}

export interface GraphProperties {
  /** Name of the drawing, for a user who does not see it; the numbers stand elsewhere. */
  label: string;
  curves: readonly Curve[];
  /** Ends of the axes in words. */
  x: (value: number) => string;
  y: (value: number) => string;
  /** A line across at this x. */
  cursor?: number | null;
}

const WIDTH = 1000;
const HEIGHT = 300;

interface Range {
  least: number;
  most: number;
}

function rangeOf(values: readonly number[]): Range {
  // Not by spreading: a trajectory has thousands.
  const least = values.reduce((a, b) => Math.min(a, b), Infinity);
  const most = values.reduce((a, b) => Math.max(a, b), -Infinity);
  return least < most ? { least, most } : { least: least - 1, most: least + 1 };
}

function share(value: number, { least, most }: Range): number {
  return (value - least) / (most - least);
}

/** Curves over one axis, each over its whole range. */
export function Graph({ label, curves, x, y, cursor = null }: GraphProperties) {
  const points = curves.flatMap((curve) => curve.points);
  if (points.length === 0) {
    return null;
  }
  const across = rangeOf(points.map(([value]) => value));
  const up = rangeOf(points.map(([, value]) => value));
  const place = ([a, b]: GraphPoint) =>
    `${(share(a, across) * WIDTH).toFixed(1)},${((1 - share(b, up)) * HEIGHT).toFixed(1)}`;
  return (
    <div className="graph">
      <span className="graph-top">{y(up.most)}</span>
      <span className="graph-bottom">{y(up.least)}</span>
      <svg
        role="img"
        aria-label={label}
        viewBox={`0 -8 ${WIDTH} ${HEIGHT + 16}`}
        preserveAspectRatio="none"
      >
        {cursor !== null && (
          <line
            className="graph-cursor"
            x1={share(cursor, across) * WIDTH}
            x2={share(cursor, across) * WIDTH}
            y1="-8"
            y2={HEIGHT + 8}
          />
        )}
        {curves.map((curve) => (
          <polyline
            key={curve.name}
            className="graph-curve"
            data-kind={curve.kind}
            points={curve.points.map(place).join(" ")}
          />
        ))}
      </svg>
      <span className="graph-left">{x(across.least)}</span>
      <span className="graph-right">{x(across.most)}</span>
    </div>
  );
}

/** Which curve is which. */
export function GraphLegend({ curves }: { curves: readonly Curve[] }) {
  return (
    <ul className="graph-legend">
      {curves.map(({ name, kind }) => (
        <li key={name}>
          <svg viewBox="0 0 40 10" aria-hidden="true">
            <polyline
              className="graph-curve"
              data-kind={kind}
              points="0,5 40,5"
            />
          </svg>{" "}
          {name}
        </li>
      ))}
    </ul>
  );
}
