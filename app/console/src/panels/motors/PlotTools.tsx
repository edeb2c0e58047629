// SPDX-License-Identifier: Apache-2.0
import { useState, type ReactNode } from "react";
import { TRACE_S, type Trace } from "../../words/trace";
import type { Range } from "./Plot";
import "./Plots.css";

const CURSOR_STEP_S = 0.05;

/** Range of a plot over time. */
export const overTime: Range = [-TRACE_S, 0];

/** The drawn trace, which is the present one or that of a pause, and a cursor in it. */
export function useShown(trace: Trace) {
  const [paused, setPaused] = useState<Trace | null>(null);
  const [agoS, setAgoS] = useState<number | null>(null);
  return {
    shown: paused ?? trace,
    /** Name of the end of what is drawn. */
    end: paused === null ? "Now" : "At the pause",
    agoS,
    setAgoS,
    /** By its place in a plot over time. */
    setCursor: (timeS: number | null) =>
      setAgoS(timeS === null ? null : -timeS),
    isPaused: paused !== null,
    toggle: () => setPaused(paused === null ? trace.copy() : null),
  };
}

export type Shown = ReturnType<typeof useShown>;

/** Name of the moment that is read. */
export function whenOf({ end, agoS }: Pick<Shown, "end" | "agoS">, s: number) {
  return (agoS ?? 0) === 0 ? end : `${s.toFixed(2)} s before`;
}

/** Pause, file and cursor of plots. */
export function PlotTools({
  plots,
  isEmpty,
  onSave,
  children,
}: {
  plots: Shown;
  isEmpty: boolean;
  onSave: () => void;
  children?: ReactNode;
}) {
  const { agoS, setAgoS, isPaused, toggle } = plots;
  return (
    <div className="orders">
      {children}
      <button type="button" onClick={toggle}>
        {isPaused ? "Go on" : "Pause"}
      </button>
      <button type="button" disabled={isEmpty} onClick={onSave}>
        Save as CSV
      </button>
      <label className="plots-cursor">
        Cursor, s before the end
        <input
          type="range"
          min={-TRACE_S}
          max={0}
          step={CURSOR_STEP_S}
          value={-(agoS ?? 0)}
          aria-valuetext={`${(agoS ?? 0).toFixed(2)} s before the end`}
          onChange={(event) => setAgoS(Math.abs(Number(event.target.value)))}
        />
      </label>
    </div>
  );
}
