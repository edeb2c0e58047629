// SPDX-License-Identifier: Apache-2.0
import { useEffect, useId, useRef, useState } from "react";
import type { Axis } from "@interface";
import { saveText } from "../download";
import { formatNumber, formatSpeed, formatValue } from "../format";
import { TRACE_S, type Trace } from "../trace";
import { Chart, chartKinds, type ChartKind } from "./chart";
import "./Plots.css";

const CURSOR_STEP_S = 0.05;

/** Where the plots are read; the pointer shows its own place. */
interface Cursor {
  agoS: number;
  isByKeys: boolean;
}

interface DrawingProperties {
  kind: ChartKind;
  axis: Axis;
  trace: Trace;
  cursor: Cursor | null;
  onCursor: (agoS: number | null) => void;
}

/** Drawn with the frames of the screen, and only when something is new. */
function Drawing({ kind, axis, trace, cursor, onCursor }: DrawingProperties) {
  const place = useRef<HTMLDivElement>(null);
  const chart = useRef<Chart | null>(null);
  const told = useRef(onCursor);
  useEffect(() => {
    told.current = onCursor;
  });
  const { name, unit } = axis;
  useEffect(() => {
    const element = place.current;
    if (element === null) {
      return undefined;
    }
    const drawing = new Chart({
      kind,
      axis: { name, unit },
      place: element,
      onCursor: (agoS) => told.current(agoS),
    });
    const observer = new ResizeObserver(() =>
      drawing.resize(element.clientWidth),
    );
    observer.observe(element);
    chart.current = drawing;
    return () => {
      observer.disconnect();
      drawing.end();
      chart.current = null;
    };
  }, [kind, name, unit]);
  useEffect(() => {
    let drawn = -1;
    let frame = 0;
    const draw = () => {
      if (trace.revision !== drawn) {
        drawn = trace.revision;
        chart.current?.draw(trace);
      }
      frame = requestAnimationFrame(draw);
    };
    draw();
    return () => cancelAnimationFrame(frame);
  }, [trace, kind, name, unit]);
  useEffect(() => {
    if (cursor?.isByKeys === true) {
      chart.current?.point(cursor.agoS);
    }
  }, [cursor]);
  return <div className="plot" ref={place} aria-hidden="true" />;
}

/** What the plot shows at the cursor, or at its end, in numbers. */
function Reading({
  axis,
  trace,
  agoS,
  end,
}: {
  axis: Axis;
  trace: Trace;
  agoS: number;
  /** What the end of the plot is. */
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

function Legend({ kind }: { kind: ChartKind }) {
  return (
    <ul className="plot-legend">
      {kind.curves.map(({ quantity, label, dash }) => (
        <li key={quantity}>
          <svg viewBox="0 0 30 10" aria-hidden="true">
            <line
              className={`plot-line-${quantity}`}
              x2="30"
              y1="5"
              y2="5"
              strokeDasharray={dash?.join(" ")}
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
  cursor,
  onCursor,
  end,
}: Omit<DrawingProperties, "kind"> & { end: string }) {
  const id = useId();
  return (
    <section className="plots-axis" aria-labelledby={id}>
      <h3 id={id}>{axis.name}</h3>
      <Reading axis={axis} trace={trace} agoS={cursor?.agoS ?? 0} end={end} />
      <div className="plots-kinds">
        {chartKinds.map((kind) => (
          <figure key={kind.title}>
            <figcaption>
              {kind.title}, {kind.unitOf(axis.unit)}
              {kind.curves.length > 1 && <Legend kind={kind} />}
            </figcaption>
            <Drawing
              kind={kind}
              axis={axis}
              trace={trace}
              cursor={cursor}
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
  const [cursor, setCursor] = useState<Cursor | null>(null);
  const shown = paused ?? trace;
  const save = () => saveText("plot.csv", "text/csv", shown.csv(chosen));
  return (
    <>
      <div className="orders">
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
            value={-(cursor?.agoS ?? 0)}
            aria-valuetext={`${(cursor?.agoS ?? 0).toFixed(2)} s before the end`}
            onChange={(event) =>
              setCursor({
                agoS: Math.abs(Number(event.target.value)),
                isByKeys: true,
              })
            }
          />
        </label>
      </div>
      {chosen.map((axis) => (
        <AxisPlots
          key={axis.name}
          axis={axis}
          trace={shown}
          cursor={cursor}
          end={paused === null ? "Now" : "At the pause"}
          onCursor={(agoS) =>
            setCursor(agoS === null ? null : { agoS, isByKeys: false })
          }
        />
      ))}
    </>
  );
}
