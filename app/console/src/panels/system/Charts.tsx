// SPDX-License-Identifier: Apache-2.0
import { charts, type Chart, type ChartName } from "@charts";
import { memo, useEffect, useId, useRef, useState } from "react";
import type { RobotState } from "@interface";
import {
  causesOf,
  keyOf,
  marked,
  observe,
  readers,
  transitionText,
  type Change,
  type Instance,
  type Leaves,
  type Seen,
} from "../../words/chart_states";
import { words } from "../../words/format";
import "./Charts.css";

const FIRST: ChartName = "workphase";
const NAMES = Object.keys(charts) as ChartName[];
/** So many pixels of a point make letters of 14 pixels. */
const LARGE = 14 / 11;

interface ChooserProperties {
  label: string;
  names: readonly string[];
  chosen: string;
  choose: (name: string) => void;
}

function Chooser({ label, names, chosen, choose }: ChooserProperties) {
  const id = useId();
  return (
    <span className="chart-chooser">
      <label htmlFor={id}>{label}</label>
      <select
        id={id}
        value={chosen}
        onChange={(event) => choose(event.target.value)}
      >
        {names.map((name) => (
          <option key={name} value={name}>
            {words(name)}
          </option>
        ))}
      </select>
    </span>
  );
}

/** By what the changes were seen. */
export interface SeenSource {
  /** From when on. */
  since: string;
  /** Name of the clock that it is from. */
  clock: string;
}

const liveSource: SeenSource = {
  since: "this view was opened",
  clock: "this computer",
};

/** The states and changes of the stream since this view was opened. */
function useSeen(robot: RobotState): Seen {
  const [seen, setSeen] = useState<Seen>(() => observe({}, robot, new Date()));
  useEffect(() => {
    setSeen((before) => observe(before, robot, new Date()));
  }, [robot]);
  return seen;
}

function Causes({
  chart,
  region,
  change,
}: {
  chart: Chart;
  region: string;
  change: Change;
}) {
  const causes = causesOf(chart, region, change);
  if (causes.length === 0) {
    return <p>In several steps: the page sees only some states a second.</p>;
  }
  return (
    <>
      {causes.length > 1 && <p>By one of these; which, is not reported:</p>}
      <ul>
        {causes.map((id) => (
          <li key={id}>{transitionText(id, chart.transitions[id]!)}</li>
        ))}
      </ul>
    </>
  );
}

interface RegionProperties {
  chart: Chart;
  region: string;
  leaf: string;
  change: Change | null;
  source: SeenSource;
}

function Region({ chart, region, leaf, change, source }: RegionProperties) {
  return (
    <div className="chart-region">
      <p>
        {region === "state" ? "State" : words(region)}:{" "}
        <strong>◆ {words(leaf)}</strong>
      </p>
      {change === null ? (
        <p>No change seen since {source.since}.</p>
      ) : (
        <>
          <p>
            Last change seen: {words(change.from)} → {words(change.to)},{" "}
            {change.at.toISOString().slice(11, 19)} UTC of {source.clock}.
          </p>
          <Causes chart={chart} region={region} change={change} />
        </>
      )}
    </div>
  );
}

/** The word on a state that is active, on its left upper corner. */
function Now({ at: [x, y] }: { at: readonly [number, number] }) {
  return (
    <g className="chart-now" transform={`translate(${x} ${y})`}>
      <rect x="-7" y="-10" width="50" height="15" rx="3" />
      <path d="M2-8L8-2 2 4-4-2z" />
      <text x="11" y="2">
        NOW
      </text>
    </g>
  );
}

interface PictureProperties {
  name: ChartName;
  leaves: Leaves;
  /** Elements that stand for the last change. */
  taken: readonly string[];
  /** The region to look at first. */
  region: string;
}

/** The drawing of the chart compiler; it is put in anew only when it is marked otherwise. */
const Lines = memo(function Lines({ html }: { html: string }) {
  // eslint-disable-next-line no-restricted-syntax -- made with this page, no text of the network
  return <g dangerouslySetInnerHTML={{ __html: html }} />;
});

function Picture({ name, leaves, taken, region }: PictureProperties) {
  const { drawing, regions, corners, size } = charts[name];
  const [isWhole, setIsWhole] = useState(false);
  const frame = useRef<HTMLDivElement>(null);
  const active = regions.map((one) => one.leaves[leaves[one.name]!]);
  const ids = active.map((states) => states?.[0] ?? "");
  const around = active.flatMap((states) => states?.slice(1) ?? []);
  const html = marked(drawing, { now: ids, within: around, taken });
  const look = ids[regions.findIndex((one) => one.name === region)] ?? "";
  const [x, y] = corners[look] ?? [0, 0];
  useEffect(() => {
    if (frame.current !== null) {
      const { clientWidth, clientHeight } = frame.current;
      frame.current.scrollLeft = x * LARGE - clientWidth / 2;
      frame.current.scrollTop = y * LARGE - clientHeight / 2;
    }
  }, [x, y, isWhole]);
  const [width, height] = size;
  return (
    <>
      <button type="button" onClick={() => setIsWhole(!isWhole)}>
        {isWhole ? "Show it large" : "Show the whole drawing"}
      </button>
      <div
        className="chart-frame"
        ref={frame}
        role="region"
        aria-label="Drawing"
        tabIndex={0}
      >
        <svg
          role="img"
          aria-label={`Chart ${words(name)}, now in ${Object.values(leaves).map(words).join(" and ")}`}
          viewBox={`0 0 ${width} ${height}`}
          width={isWhole ? "100%" : width * LARGE}
          height={isWhole ? "73vh" : height * LARGE}
        >
          <Lines html={html} />
          {ids.map((id) => {
            const corner = corners[id];
            return corner && <Now key={id} at={corner} />;
          })}
        </svg>
      </div>
    </>
  );
}

function marksOf(chart: Chart, region: string, change: Change | null) {
  const causes = change === null ? [] : causesOf(chart, region, change);
  return causes.flatMap((id) => chart.transitions[id]?.marks ?? []);
}

/** Each region with its state and the last change of it. */
function regionsOf(
  chart: Chart,
  name: ChartName,
  instance: Instance,
  seen: Seen,
) {
  return chart.regions.map((region) => ({
    region: region.name,
    leaf: instance.leaves[region.name] ?? "",
    change: seen[keyOf(name, instance.name, region.name)]?.change ?? null,
  }));
}

/** The one that has changed last. */
function latestOf(regions: ReturnType<typeof regionsOf>) {
  const time = ({ change }: (typeof regions)[number]) =>
    change?.at.getTime() ?? 0;
  return regions.reduce((one, other) =>
    time(other) >= time(one) ? other : one,
  );
}

/** The charts with what was seen of them until now. */
export function SeenCharts({
  robot,
  seen,
  source,
}: {
  robot: RobotState;
  seen: Seen;
  source: SeenSource;
}) {
  const [name, setName] = useState<ChartName>(FIRST);
  const [instanceName, setInstanceName] = useState("");
  const chart = charts[name];
  const instances = readers[name](robot);
  const instance: Instance | undefined =
    instances.find((one) => one.name === instanceName) ?? instances[0];
  if (instance === undefined) {
    return null;
  }
  const regions = regionsOf(chart, name, instance, seen);
  return (
    <div className="charts">
      <div className="chart-choosers">
        <Chooser
          label="Chart"
          names={NAMES}
          chosen={name}
          choose={(chosen) => setName(chosen as ChartName)}
        />
        {instances.length > 1 && (
          <Chooser
            label="Of"
            names={instances.map((one) => one.name)}
            chosen={instance.name}
            choose={setInstanceName}
          />
        )}
      </div>
      <p className="chart-about">{chart.about}</p>
      {regions.map((region) => (
        <Region key={region.region} chart={chart} source={source} {...region} />
      ))}
      <p className="chart-about">
        In the drawing: ◆ NOW and a thick frame, the state that it is in; a
        thick line, the last change seen.
      </p>
      <Picture
        name={name}
        leaves={instance.leaves}
        region={latestOf(regions).region}
        taken={regions.flatMap(({ region, change }) =>
          marksOf(chart, region, change),
        )}
      />
    </div>
  );
}

/**
 * The charts as they are drawn, with what they are in.
 *
 * @satisfies SWR-CON-031
 */
export function Charts({ robot }: { robot: RobotState }) {
  return <SeenCharts robot={robot} seen={useSeen(robot)} source={liveSource} />;
}
