// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState, type PointerEvent } from "react";
import "./Plot.css";

const HEIGHT = 150;
/** Until its place on the screen is known. */
const WIDTH = 600;
/** Around what is drawn, for the words at the axes. */
const LEFT = 64;
const RIGHT = 20;
const TOP = 8;
const BOTTOM = 26;
/** Between two words at an axis. */
const ROOM_ACROSS = 60;
const ROOM_UP = 24;
/** Less than this is not drawn larger: it would be noise. */
const LEAST_RANGE = 1;

export type Range = readonly [low: number, high: number];

/** Null: not known. */
export type Column = readonly (number | null)[];

export interface PlotCurve {
  /** Its look: the end of its class. */
  look: string;
  label: string;
  dash?: string;
  values: Column;
}

/** A line across all curves. */
export interface PlotMark {
  /** Its look: the end of its class. */
  look: string;
  /** Its kind in the legend. */
  label: string;
  place: number;
}

export function rangeOf(columns: readonly Column[]): Range {
  const values = columns.flat().filter((value) => value !== null);
  const low = values.reduce((a, b) => Math.min(a, b), values[0] ?? 0);
  const high = values.reduce((a, b) => Math.max(a, b), low);
  const room = Math.max((high - low) * 0.1, (LEAST_RANGE - (high - low)) / 2);
  return [low - room, high + room];
}

/** Round numbers in the range, at most so many of its length. */
function ticksOf([low, high]: Range, most: number): string[] {
  const least = (high - low) / Math.max(1, most);
  const power = Math.floor(Math.log10(least));
  const step =
    [1, 2, 5]
      .map((one) => one * 10 ** power)
      .find((one) => one >= least * (1 - Number.EPSILON)) ?? 10 ** (power + 1);
  const decimals = Math.max(0, -Math.floor(Math.log10(step)));
  const first = Math.ceil(low / step);
  const count = Math.floor(high / step) - first + 1;
  return Array.from({ length: count }, (_, index) =>
    // Nothing is less than zero by no digit.
    ((first + index) * step + 0).toFixed(decimals),
  );
}

function tenths(value: number): number {
  return Math.round(value * 10) / 10;
}

/** From a range of values to a way on the screen. */
function scaleOf([low, high]: Range, [from, to]: Range) {
  return (value: number) =>
    tenths(from + ((value - low) / (high - low)) * (to - from));
}

/** A null interrupts it; a value that is known for a moment is a point. */
function pathOf(xs: Column, ys: Column): string {
  const isKnown = (index: number) =>
    (xs[index] ?? null) !== null && (ys[index] ?? null) !== null;
  return ys
    .map((y, index) => {
      if (!isKnown(index)) {
        return "";
      }
      const place = `${xs[index]},${y}`;
      return isKnown(index - 1) ? `L${place}` : `M${place}h0`;
    })
    .join("");
}

/** Width of the element on the screen. */
function useWidth() {
  const [width, setWidth] = useState(WIDTH);
  const place = useRef<SVGSVGElement>(null);
  useEffect(() => {
    const element = place.current;
    const observer = new ResizeObserver(() =>
      setWidth(Math.max(LEFT + RIGHT + 1, element?.clientWidth ?? WIDTH)),
    );
    if (element !== null) {
      observer.observe(element);
    }
    return () => observer.disconnect();
  }, []);
  return { width, place };
}

export interface PlotProperties {
  curves: readonly PlotCurve[];
  /** Places across of their values. */
  places: Column;
  across: Range;
  /** Unit of the places. */
  unit: string;
  range?: Range | undefined;
  /** A place across; null: there is none. */
  cursor: number | null;
  onCursor?: (place: number | null) => void;
  marks?: readonly PlotMark[] | undefined;
}

/** Lines from the top of the plot to its bottom. */
function Marks({
  marks,
  x,
  bottom,
}: {
  marks: readonly PlotMark[];
  x: (value: number) => number;
  bottom: number;
}) {
  return marks.map(({ look, place }) => (
    <path
      key={`${look} ${place}`}
      className={`plot-mark plot-mark-${look}`}
      d={`M${x(place)},${TOP}V${bottom}`}
    />
  ));
}

/**
 * Curves over one axis. The numbers of it stand elsewhere.
 *
 * @satisfies SWR-CON-027
 * @satisfies SWR-CON-611
 */
function Plot(properties: PlotProperties) {
  const { curves, places, across, unit, cursor, onCursor, marks } = properties;
  const { width, place } = useWidth();
  const [right, bottom] = [width - RIGHT, HEIGHT - BOTTOM];
  const range = properties.range ?? rangeOf(curves.map(({ values }) => values));
  const x = scaleOf(across, [LEFT, right]);
  const y = scaleOf(range, [bottom, TOP]);
  const ticks = ticksOf(across, (right - LEFT) / ROOM_ACROSS);
  const up = ticksOf(range, (bottom - TOP) / ROOM_UP);
  const grid = [
    ...ticks.map((tick) => `M${x(Number(tick))},${TOP}V${bottom}`),
    ...up.map((tick) => `M${LEFT},${y(Number(tick))}H${right}`),
  ].join("");
  const placed = (column: Column, scale: (value: number) => number) =>
    column.map((value) => (value === null ? null : scale(value)));
  const xs = placed(places, x);
  const point = ({ clientX, currentTarget }: PointerEvent<SVGSVGElement>) => {
    const way = clientX - currentTarget.getBoundingClientRect().left - LEFT;
    const share = way / (right - LEFT);
    const [low, high] = across;
    onCursor?.(share >= 0 && share <= 1 ? low + share * (high - low) : null);
  };
  return (
    <svg
      className="plot"
      ref={place}
      viewBox={`0 0 ${width} ${HEIGHT}`}
      aria-hidden="true"
      onPointerMove={point}
      onPointerLeave={() => onCursor?.(null)}
    >
      <path className="plot-grid" d={grid} />
      {ticks.map((tick) => (
        <text key={tick} x={x(Number(tick))} y={HEIGHT - 6} textAnchor="middle">
          {tick} {unit}
        </text>
      ))}
      {up.map((tick) => (
        <text key={tick} x={LEFT - 6} y={y(Number(tick)) + 5} textAnchor="end">
          {tick}
        </text>
      ))}
      {marks !== undefined && <Marks marks={marks} x={x} bottom={bottom} />}
      {curves.map(({ look, dash, values }) => (
        <path
          key={look}
          className={`plot-line plot-line-${look}`}
          strokeDasharray={dash}
          d={pathOf(xs, placed(values, y))}
        />
      ))}
      {cursor !== null && (
        <path className="plot-cursor" d={`M${x(cursor)},${TOP}V${bottom}`} />
      )}
    </svg>
  );
}

/** Which curve is which, and which mark. */
function Legend({
  curves,
  marks = [],
}: Pick<PlotProperties, "curves" | "marks">) {
  const kinds = new Map(marks.map(({ look, label }) => [look, label]));
  return (
    <ul className="plot-legend">
      {curves.map(({ look, label, dash }) => (
        <li key={look}>
          <svg viewBox="0 0 30 10" aria-hidden="true">
            <line
              className={`plot-line plot-line-${look}`}
              x2="30"
              y1="5"
              y2="5"
              strokeDasharray={dash}
            />
          </svg>
          {label}
        </li>
      ))}
      {[...kinds].map(([look, label]) => (
        <li key={look}>
          <svg viewBox="0 0 30 10" aria-hidden="true">
            <path className={`plot-mark plot-mark-${look}`} d="M15,0V10" />
          </svg>
          {label}
        </li>
      ))}
    </ul>
  );
}

/** A plot with its title above. */
export function Figure({
  title,
  ...properties
}: PlotProperties & { title: string }) {
  const { curves, marks } = properties;
  return (
    <figure>
      <figcaption>
        {title}
        {curves.length > 1 && <Legend curves={curves} marks={marks} />}
      </figcaption>
      <Plot {...properties} />
    </figure>
  );
}
