// SPDX-License-Identifier: Apache-2.0
import { useId, useState } from "react";
import type { Axis } from "@interface";
import { saveText } from "../../words/download";
import { formatNumber, formatSpeed, formatValue } from "../../words/format";
import { TRACE_S, type Trace } from "../../words/trace";
import { Plot, plotKinds, type PlotKind, type PlotProperties } from "./Plot";
import "./Plots.css";

const CURSOR_STEP_S = 0.05;

/** The values of the plot at the cursor, or at its end, in numbers. */
function Reading({
  axis,
  trace,
  agoS,
  end,
}: {
  axis: Axis;
  trace: Trace;
  agoS: number;
  /** Name of the end of the plot. */
  end: string;
}) {
  const values = trace.at(axis.name, agoS);
  if (values === null) {
    return <p className="plot-reading">No data.</p>;
  }
  const when = agoS === 0 ? end : `${values.agoS.toFixed(2)} s before`;
  return (
    <p className="plot-reading">
      <span>{when}</span>
      <span>set-point {formatValue(values.setpoint, axis.unit)}</span>
      <span>position {formatValue(values.position, axis.unit)}</span>
      <span>goal {formatValue(values.goal, axis.unit)}</span>
      <span>speed {formatSpeed(values.speed, axis.unit)}</span>
      <span>output {formatNumber(values.output, 0)} %</span>
    </p>
  );
}

function Legend({ kind }: { kind: PlotKind }) {
  return (
    <ul className="plot-legend">
      {kind.curves.map(({ quantity, label, dash }) => (
        <li key={quantity}>
          <svg viewBox="0 0 30 10" aria-hidden="true">
            <line
              className={`plot-line plot-line-${quantity}`}
              x2="30"
              y1="5"
              y2="5"
              strokeDasharray={dash}
            />
          </svg>
          {label}
        </li>
      ))}
    </ul>
  );
}

function AxisPlots({
  axis,
  trace,
  agoS,
  onCursor,
  end,
}: Omit<PlotProperties, "kind"> & { end: string }) {
  const id = useId();
  return (
    <section className="plots-axis" aria-labelledby={id}>
      <h3 id={id}>{axis.name}</h3>
      <Reading axis={axis} trace={trace} agoS={agoS ?? 0} end={end} />
      <div className="plots-kinds">
        {plotKinds.map((kind) => (
          <figure key={kind.title}>
            <figcaption>
              {kind.title}, {kind.unitOf(axis.unit)}
              {kind.curves.length > 1 && <Legend kind={kind} />}
            </figcaption>
            <Plot
              kind={kind}
              axis={axis}
              trace={trace}
              agoS={agoS}
              onCursor={onCursor}
            />
          </figure>
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
  const [paused, setPaused] = useState<Trace | null>(null);
  const [cursor, setCursor] = useState<number | null>(null);
  const shown = paused ?? trace;
  const save = () => saveText("plot.csv", "text/csv", shown.csv(chosen));
  return (
    <>
      <div className="orders">
        <AxisChoices axes={axes} chosen={chosen} toggle={toggle} />
        <button
          type="button"
          onClick={() => setPaused(paused === null ? trace.copy() : null)}
        >
          {paused === null ? "Pause" : "Go on"}
        </button>
        <button type="button" disabled={chosen.length === 0} onClick={save}>
          Save as CSV
        </button>
        <label className="plots-cursor">
          Cursor, s before the end
          <input
            type="range"
            min={-TRACE_S}
            max={0}
            step={CURSOR_STEP_S}
            value={-(cursor ?? 0)}
            aria-valuetext={`${(cursor ?? 0).toFixed(2)} s before the end`}
            onChange={(event) =>
              setCursor(Math.abs(Number(event.target.value)))
            }
          />
        </label>
      </div>
      {chosen.map((axis) => (
        <AxisPlots
          key={axis.name}
          axis={axis}
          trace={shown}
          agoS={cursor}
          end={paused === null ? "Now" : "At the pause"}
          onCursor={setCursor}
        />
      ))}
    </>
  );
}
