// SPDX-License-Identifier: Apache-2.0
import type { LogEntry } from "@interface";
import { words } from "../words/format";
import type { Recording, Span } from "./recording";
import "./Timeline.css";

const WIDTH = 1000;
const LANE = 26;
const AXIS_HEIGHT = 34;
/** A line needs no more points than it has pixels. */
const POINTS = 800;

/** From a cycle to its place in the drawing. */
type Scale = (cycle: number) => number;

function rectangle({ from, to }: Span, scale: Scale): string {
  const [left, right] = [scale(from), scale(to)];
  return `M${left.toFixed(1)} 0V${LANE - 6}H${Math.max(right, left + 0.5).toFixed(1)}V0z`;
}

/** One path for each kind: there may be many thousand spans. */
function Lane({
  spans,
  scale,
  name,
}: {
  spans: readonly Span[];
  scale: Scale;
  name: string;
}) {
  const kinds = [...new Set(spans.map(({ kind }) => kind))].filter(
    (kind) => kind !== "",
  );
  return (
    <g data-lane={name}>
      {kinds.map((kind) => (
        <path
          key={kind}
          data-kind={kind}
          d={spans
            .filter((span) => span.kind === kind)
            .map((span) => rectangle(span, scale))
            .join("")}
        />
      ))}
    </g>
  );
}

function Marks({
  events,
  scale,
}: {
  events: readonly LogEntry[];
  scale: Scale;
}) {
  return (
    <g data-lane="events">
      {events.map(({ number, cycle, severity }) => (
        <path
          key={number}
          data-severity={severity}
          transform={`translate(${scale(cycle).toFixed(1)} 10)`}
          d={severity === "INFORMATION" ? "M-1-8h2V8h-2z" : "M0-8L6 8H-6z"}
        />
      ))}
    </g>
  );
}

/** Where the axis stood, between the least and the most of the recording; nothing is drawn over a gap. */
function Curve({
  recording,
  name,
  scale,
}: {
  recording: Recording;
  name: string;
  scale: Scale;
}) {
  const { trace } = recording;
  const times = trace.times();
  const places = trace.column(name, "position");
  const step = Math.max(1, Math.ceil(places.length / POINTS));
  const known = places.filter((place) => place !== null);
  const low = known.reduce((one, other) => Math.min(one, other), Infinity);
  const high = known.reduce((one, other) => Math.max(one, other), -Infinity);
  const start = times[0] ?? 0;
  const lines: string[][] = [];
  let line: string[] | null = null;
  places.forEach((place, index) => {
    if (place === null) {
      line = null;
    } else if (line === null || index % step === 0) {
      const x = scale(recording.cycleOf((times[index] ?? 0) - start));
      const y = AXIS_HEIGHT - 4 - ((place - low) / (high - low || 1)) * 26;
      if (line === null) {
        line = [];
        lines.push(line);
      }
      line.push(`${x.toFixed(1)},${y.toFixed(1)}`);
    }
  });
  return lines.map((points, index) => (
    <polyline key={index} points={points.join(" ")} />
  ));
}

export interface TimelineProperties {
  recording: Recording;
  cycle: number;
  onCycle: (cycle: number) => void;
  /** The cycle in words. */
  says: string;
}

function rowsOf(
  recording: Recording,
  scale: Scale,
): { label: string; height: number; content: React.ReactNode }[] {
  const { lanes, events, robot } = recording;
  const axes = robot.axes.map(({ name }) => name);
  return [
    {
      label: "Workphase",
      height: LANE,
      content: (
        <Lane name="workphases" spans={lanes.workphases} scale={scale} />
      ),
    },
    {
      label: "Motion",
      height: LANE,
      content: <Lane name="signs" spans={lanes.signs} scale={scale} />,
    },
    {
      label: "Reasons",
      height: LANE,
      content: <Lane name="reasons" spans={lanes.reasons} scale={scale} />,
    },
    {
      label: "Events",
      height: LANE,
      content: <Marks events={events} scale={scale} />,
    },
    ...axes.map((name) => ({
      label: words(name),
      height: AXIS_HEIGHT,
      content: <Curve recording={recording} name={name} scale={scale} />,
    })),
  ];
}

/**
 * The recording from its begin to its end, and the cycle that is looked at.
 *
 * @satisfies SWR-REPLAY-018
 */
export function Timeline({
  recording,
  cycle,
  onCycle,
  says,
}: TimelineProperties) {
  const { first, last } = recording;
  const scale: Scale = (one) => (WIDTH * (one - first)) / (last - first || 1);
  return (
    <div className="timeline">
      {rowsOf(recording, scale).map(({ label, height, content }) => (
        <div className="timeline-row" key={label}>
          <span className="timeline-label">{label}</span>
          <svg
            aria-hidden="true"
            viewBox={`0 0 ${WIDTH} ${height}`}
            height={height}
            preserveAspectRatio="none"
          >
            {content}
            <line
              className="timeline-cursor"
              x1={scale(cycle)}
              x2={scale(cycle)}
              y2={height}
            />
          </svg>
        </div>
      ))}
      <label className="timeline-row">
        <span className="timeline-label">Cycle</span>
        <input
          type="range"
          min={first}
          max={last}
          step={1}
          value={cycle}
          aria-valuetext={says}
          onChange={(event) => onCycle(Number(event.target.value))}
        />
      </label>
    </div>
  );
}
