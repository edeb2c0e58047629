// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState, type PointerEvent } from "react";
import type { Axis } from "@interface";
import { units } from "../../words/format";
import { TRACE_S, type Quantity, type Trace } from "../../words/trace";
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
const MOST_OUTPUT = 100;

type Range = readonly [low: number, high: number];

interface PlotCurve {
  quantity: Quantity;
  label: string;
  dash?: string;
}

export interface PlotKind {
  title: string;
  unitOf: (unit: Axis["unit"]) => string;
  curves: readonly PlotCurve[];
  range?: Range;
}

export const plotKinds: readonly PlotKind[] = [
  {
    title: "Goal, set-point and position",
    unitOf: (unit) => units[unit],
    curves: [
      { quantity: "position", label: "position" },
      { quantity: "setpoint", label: "set-point", dash: "8 5" },
      { quantity: "goal", label: "goal", dash: "2 4" },
    ],
  },
  {
    title: "Speed",
    unitOf: (unit) => `${units[unit]}/s`,
    curves: [{ quantity: "speed", label: "speed" }],
  },
  {
    title: "Output",
    unitOf: () => "%",
    curves: [{ quantity: "output", label: "output" }],
    range: [-MOST_OUTPUT, MOST_OUTPUT],
  },
];

type Column = readonly (number | null)[];

function rangeOf(columns: readonly Column[]): Range {
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
function pathOf(xs: readonly number[], ys: Column): string {
  return ys
    .map((y, index) => {
      if (y === null) {
        return "";
      }
      const place = `${xs[index]},${y}`;
      return (ys[index - 1] ?? null) === null ? `M${place}h0` : `L${place}`;
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
  kind: PlotKind;
  axis: Axis;
  trace: Trace;
  /** The cursor is so many seconds before the end; null: there is none. */
  agoS: number | null;
  onCursor: (agoS: number | null) => void;
}

/**
 * The last 30 s of an axis. The numbers of it stand elsewhere.
 *
 * @satisfies SWR-CON-027
 */
export function Plot({ kind, axis, trace, agoS, onCursor }: PlotProperties) {
  const { width, place } = useWidth();
  const [right, bottom] = [width - RIGHT, HEIGHT - BOTTOM];
  const columns = kind.curves.map(({ quantity }) =>
    trace.column(axis.name, quantity),
  );
  const range = kind.range ?? rangeOf(columns);
  const x = scaleOf([-TRACE_S, 0], [LEFT, right]);
  const y = scaleOf(range, [bottom, TOP]);
  const across = ticksOf([-TRACE_S, 0], (right - LEFT) / ROOM_ACROSS);
  const up = ticksOf(range, (bottom - TOP) / ROOM_UP);
  const grid = [
    ...across.map((tick) => `M${x(Number(tick))},${TOP}V${bottom}`),
    ...up.map((tick) => `M${LEFT},${y(Number(tick))}H${right}`),
  ].join("");
  const times = trace.times().map(x);
  const point = ({ clientX, currentTarget }: PointerEvent<SVGSVGElement>) => {
    const way = clientX - currentTarget.getBoundingClientRect().left - LEFT;
    const share = way / (right - LEFT);
    onCursor(share >= 0 && share <= 1 ? (1 - share) * TRACE_S : null);
  };
  return (
    <svg
      className="plot"
      ref={place}
      viewBox={`0 0 ${width} ${HEIGHT}`}
      aria-hidden="true"
      onPointerMove={point}
      onPointerLeave={() => onCursor(null)}
    >
      <path className="plot-grid" d={grid} />
      {across.map((tick) => (
        <text key={tick} x={x(Number(tick))} y={HEIGHT - 6} textAnchor="middle">
          {tick} s
        </text>
      ))}
      {up.map((tick) => (
        <text key={tick} x={LEFT - 6} y={y(Number(tick)) + 5} textAnchor="end">
          {tick}
        </text>
      ))}
      {kind.curves.map(({ quantity, dash }, index) => (
        <path
          key={quantity}
          className={`plot-line plot-line-${quantity}`}
          strokeDasharray={dash}
          d={pathOf(
            times,
            columns[index]!.map((value) => (value === null ? null : y(value))),
          )}
        />
      ))}
      {agoS !== null && (
        <path className="plot-cursor" d={`M${x(-agoS)},${TOP}V${bottom}`} />
      )}
    </svg>
  );
}
