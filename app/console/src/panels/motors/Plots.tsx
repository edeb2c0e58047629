// SPDX-License-Identifier: Apache-2.0
import { useId, useState } from "react";
import type { Axis } from "@interface";
import { saveText } from "../../words/download";
import {
  formatNumber,
  formatSpeed,
  formatValue,
  units,
} from "../../words/format";
import type { Quantity, Trace } from "../../words/trace";
import { Figure, type Range } from "./Plot";
import { overTime, PlotTools, useShown, whenOf, type Shown } from "./PlotTools";

const MOST_OUTPUT = 100;

interface PlotKind {
  title: string;
  unitOf: (unit: Axis["unit"]) => string;
  curves: readonly { look: Quantity; label: string; dash?: string }[];
  range?: Range;
}

const plotKinds: readonly PlotKind[] = [
  {
    title: "Goal, set-point and position",
    unitOf: (unit) => units[unit],
    curves: [
      { look: "position", label: "position" },
      { look: "setpoint", label: "set-point", dash: "8 5" },
      { look: "goal", label: "goal", dash: "2 4" },
    ],
  },
  {
    title: "Speed",
    unitOf: (unit) => `${units[unit]}/s`,
    curves: [{ look: "speed", label: "speed" }],
  },
  {
    title: "Output",
    unitOf: () => "%",
    curves: [{ look: "output", label: "output" }],
    range: [-MOST_OUTPUT, MOST_OUTPUT],
  },
];

/** The values of the plot at the cursor, or at its end, in numbers. */
function Reading({ axis, plots }: { axis: Axis; plots: Shown }) {
  const values = plots.shown.at(axis.name, plots.agoS ?? 0);
  if (values === null) {
    return <p className="plot-reading">No data.</p>;
  }
  return (
    <p className="plot-reading">
      <span>{whenOf(plots, values.agoS)}</span>
      <span>set-point {formatValue(values.setpoint, axis.unit)}</span>
      <span>position {formatValue(values.position, axis.unit)}</span>
      <span>goal {formatValue(values.goal, axis.unit)}</span>
      <span>speed {formatSpeed(values.speed, axis.unit)}</span>
      <span>output {formatNumber(values.output, 0)} %</span>
    </p>
  );
}

function AxisPlots({ axis, plots }: { axis: Axis; plots: Shown }) {
  const id = useId();
  const { shown, agoS, setCursor } = plots;
  return (
    <section className="plots-axis" aria-labelledby={id}>
      <h3 id={id}>{axis.name}</h3>
      <Reading axis={axis} plots={plots} />
      <div className="plots-kinds">
        {plotKinds.map(({ title, unitOf, curves, range }) => (
          <Figure
            key={title}
            title={`${title}, ${unitOf(axis.unit)}`}
            curves={curves.map((curve) => ({
              ...curve,
              values: shown.column(axis.name, curve.look),
            }))}
            places={shown.times()}
            across={overTime}
            unit="s"
            range={range}
            cursor={agoS === null ? null : -agoS}
            onCursor={setCursor}
          />
        ))}
      </div>
    </section>
  );
}

/** Which of them are drawn; the first one at the beginning. */
function useChosen(axes: readonly Axis[]) {
  const [names, setNames] = useState<readonly string[] | null>(null);
  const present = names ?? axes.slice(0, 1).map(({ name }) => name);
  const toggle = (name: string) =>
    setNames(
      present.includes(name)
        ? present.filter((one) => one !== name)
        : [...present, name],
    );
  return { chosen: axes.filter(({ name }) => present.includes(name)), toggle };
}

function AxisChoices({
  axes,
  chosen,
  toggle,
}: {
  axes: readonly Axis[];
  chosen: readonly Axis[];
  toggle: (name: string) => void;
}) {
  return (
    <fieldset className="plots-axes">
      <legend>Axes</legend>
      {axes.map(({ name }) => (
        <label key={name}>
          <input
            type="checkbox"
            checked={chosen.some((one) => one.name === name)}
            onChange={() => toggle(name)}
          />{" "}
          {name}
        </label>
      ))}
    </fieldset>
  );
}

/**
 * The last 30 s of the chosen axes.
 *
 * @satisfies SWR-CON-027
 */
export function Plots({
  axes,
  trace,
}: {
  axes: readonly Axis[];
  trace: Trace;
}) {
  const { chosen, toggle } = useChosen(axes);
  const plots = useShown(trace);
  return (
    <>
      <PlotTools
        plots={plots}
        isEmpty={chosen.length === 0}
        onSave={() => saveText("plot.csv", "text/csv", plots.shown.csv(chosen))}
      >
        <AxisChoices axes={axes} chosen={chosen} toggle={toggle} />
      </PlotTools>
      {chosen.map((axis) => (
        <AxisPlots key={axis.name} axis={axis} plots={plots} />
      ))}
    </>
  );
}
