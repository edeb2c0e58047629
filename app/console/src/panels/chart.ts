// SPDX-License-Identifier: Apache-2.0
// How a chart looks. The colours are those of the theme, read anew for each drawing.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { Axis } from "@interface";
import { units } from "../format";
import { TRACE_S, type Quantity, type Trace } from "../trace";

const HEIGHT = 150;
const FONT = '14px system-ui, "DejaVu Sans", sans-serif';
const AXIS_WIDTH = 64;
/** Less than this is not drawn larger: it would be noise. */
const LEAST_RANGE = 1;
const MOST_OUTPUT = 100;

export interface PlotLine {
  quantity: Quantity;
  label: string;
  /** A variable of the theme. */
  colour: string;
  dash?: number[];
}

export interface ChartKind {
  title: string;
  unitOf: (unit: Axis["unit"]) => string;
  curves: readonly PlotLine[];
  range?: [number, number];
}

export const chartKinds: readonly ChartKind[] = [
  {
    title: "Goal, set-point and position",
    unitOf: (unit) => units[unit],
    curves: [
      { quantity: "position", label: "position", colour: "--text" },
      {
        quantity: "setpoint",
        label: "set-point",
        colour: "--active",
        dash: [8, 5],
      },
      { quantity: "goal", label: "goal", colour: "--quiet", dash: [2, 4] },
    ],
  },
  {
    title: "Speed",
    unitOf: (unit) => `${units[unit]}/s`,
    curves: [{ quantity: "speed", label: "speed", colour: "--text" }],
  },
  {
    title: "Output",
    unitOf: () => "%",
    curves: [{ quantity: "output", label: "output", colour: "--text" }],
    range: [-MOST_OUTPUT, MOST_OUTPUT],
  },
];

function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name);
}

function rangeOf(least: number | null, most: number | null): [number, number] {
  const low = least ?? 0;
  const high = most ?? 0;
  const room = Math.max((high - low) * 0.1, (LEAST_RANGE - (high - low)) / 2);
  return [low - room, high + room];
}

function axisOf(rest: uPlot.Axis): uPlot.Axis {
  return {
    font: FONT,
    labelFont: FONT,
    stroke: () => colour("--text"),
    grid: { stroke: () => colour("--line"), width: 1 },
    ticks: { stroke: () => colour("--line"), width: 1 },
    ...rest,
  };
}

function dataOf(kind: ChartKind, name: string, trace: Trace) {
  return [
    trace.times(),
    ...kind.curves.map(({ quantity }) => trace.column(name, quantity)),
  ] as uPlot.AlignedData;
}

export interface ChartOptions {
  kind: ChartKind;
  axis: Pick<Axis, "name" | "unit">;
  place: HTMLElement;
  /** The cursor is so many seconds before the end; null: it is gone. */
  onCursor: (agoS: number | null) => void;
}

/** The drawing of a kind for one axis, in `place`. */
export class Chart {
  private readonly kind: ChartKind;
  private readonly name: string;
  private readonly plot: uPlot;

  constructor({ kind, axis, place, onCursor }: ChartOptions) {
    this.kind = kind;
    this.name = axis.name;
    this.plot = new uPlot(
      {
        width: Math.max(1, place.clientWidth),
        height: HEIGHT,
        legend: { show: false },
        cursor: {
          y: false,
          drag: { x: false, y: false },
          sync: { key: "boresight" },
        },
        scales: {
          x: { time: false, range: [-TRACE_S, 0] },
          y: { range: kind.range ?? ((_, low, high) => rangeOf(low, high)) },
        },
        axes: [
          axisOf({
            values: (_, places) => places.map((one) => `${String(one)} s`),
          }),
          axisOf({ size: AXIS_WIDTH, label: kind.unitOf(axis.unit) }),
        ],
        series: [
          {},
          ...kind.curves.map((curve) => ({
            label: curve.label,
            stroke: () => colour(curve.colour),
            width: 2,
            points: { show: false },
            ...(curve.dash && { dash: curve.dash }),
          })),
        ],
        hooks: {
          setCursor: [
            ({ cursor, data }) => {
              const timeS = cursor.idx == null ? null : data[0][cursor.idx];
              onCursor(timeS == null ? null : -timeS);
            },
          ],
        },
      },
      [[], ...kind.curves.map(() => [])] as uPlot.AlignedData,
      place,
    );
  }

  draw(trace: Trace): void {
    this.plot.setData(dataOf(this.kind, this.name, trace));
  }

  /** Puts the cursor there without telling of it. */
  point(agoS: number): void {
    this.plot.setCursor(
      { left: this.plot.valToPos(-agoS, "x"), top: 0 },
      false,
    );
  }

  resize(width: number): void {
    this.plot.setSize({ width: Math.max(1, width), height: HEIGHT });
  }

  end(): void {
    this.plot.destroy();
  }
}
