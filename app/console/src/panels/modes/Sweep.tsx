// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";
import { commands, Log, Sweep as Kept } from "@interface";
import type { Axis, Path, SweepPoint } from "@interface";
import { formatNumber, words } from "../../words/format";
import { useAnswer } from "../../state/answer";
import { ASK_AGAIN_MS, reasonAgainst } from "../../state/outlook";
import type { Page } from "../../state/page";
import {
  Graph,
  GraphLegend,
  type Curve,
  type GraphPoint,
} from "../../parts/drawn/Graph";
import { Order } from "../../parts/Order";
import { readRuns, type SweepRun } from "../../words/sweep_runs";
import type { ModePanelProperties } from "./mode_panel";

const PATH: Path = "/api/v1/sweep";
const CSV_PATH: Path = "/api/v1/sweep.csv";
/** Entries of the log about the present sweep; a whole sweep has fewer. */
const LOG_PATH = "/api/v1/log?text=SWEEP_&limit=200" as Path;

const states: Readonly<Record<Kept["state"], string>> = {
  none: "No sweep of this robot is kept yet.",
  kept: "",
  damaged: "The sweep that was kept is damaged, and not shown.",
  other_robot:
    "The sweep that was kept is of another robot or another file of it, and not shown.",
};

function kilohertz(value: number): string {
  return `${formatNumber(value / 1000, 2)} kHz`;
}

function curvesOf(points: readonly SweepPoint[]): Curve[] {
  const curve = (value: (point: SweepPoint) => number | null): GraphPoint[] =>
    points.flatMap((point) => {
      const speed = value(point);
      return speed === null ? [] : [[point.frequency_hz, speed] as const];
    });
  return [
    { name: "upwards", kind: "first", points: curve((one) => one.upwards_rpm) },
    {
      name: "downwards",
      kind: "second",
      points: curve((one) => one.downwards_rpm),
    },
    {
      name: "expected by the robot's file",
      kind: "third",
      points: curve((one) => one.expected_rpm),
    },
  ];
}

function speed(value: number | null): string {
  return value === null ? "–" : formatNumber(value, 2);
}

function PointRow({
  point,
  isChosen,
}: {
  point: SweepPoint;
  isChosen: boolean;
}) {
  return (
    <tr aria-current={isChosen ? true : undefined}>
      <th scope="row" className="number">
        {kilohertz(point.frequency_hz)}
      </th>
      <td className="number">{speed(point.upwards_rpm)}</td>
      <td className="number">{speed(point.downwards_rpm)}</td>
      <td className="number">{speed(point.expected_rpm)}</td>
    </tr>
  );
}

function PointsTable({
  points,
  chosen,
}: {
  points: readonly SweepPoint[];
  chosen: number;
}) {
  return (
    <div
      className="table-scroll sweep-table"
      role="region"
      aria-label="Points of the sweep"
      tabIndex={0}
    >
      <table>
        <thead>
          <tr>
            {[
              "Frequency",
              "Upwards, /min",
              "Downwards, /min",
              "Expected, /min",
            ].map((name) => (
              <th key={name} scope="col" className="number">
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {points.map((one, at) => (
            <PointRow
              key={one.frequency_hz}
              point={one}
              isChosen={at === chosen}
            />
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** The cursor is moved in the list of points, whose row then stands out. */
function KeptCurve({ kept }: { kept: readonly SweepPoint[] }) {
  const points = kept.toReversed(); // As drawn, from left to right.
  const [chosen, setChosen] = useState(0);
  const index = Math.min(chosen, points.length - 1);
  const point = points[index];
  const curves = curvesOf(points);
  if (point === undefined) {
    return null;
  }
  const said = `${kilohertz(point.frequency_hz)}: upwards ${speed(point.upwards_rpm)}, downwards ${speed(point.downwards_rpm)}, expected ${speed(point.expected_rpm)} /min`;
  return (
    <>
      <GraphLegend curves={curves} />
      <Graph
        label="Turns a minute by frequency; the numbers stand in the table below"
        curves={curves}
        x={kilohertz}
        y={(value) => `${formatNumber(value, 0)} /min`}
        cursor={point.frequency_hz}
      />
      <label className="cursor">
        Cursor{" "}
        <input
          type="range"
          min={0}
          max={points.length - 1}
          value={index}
          aria-valuetext={said}
          onChange={(event) => setChosen(Number(event.target.value))}
        />
      </label>
      <p>{said}</p>
      <PointsTable points={points} chosen={index} />
    </>
  );
}

function KeptSweep({ kept }: { kept: Kept | null }) {
  if (kept === null) {
    return <p>Whether a sweep is kept is not known yet.</p>;
  }
  return (
    <>
      <h3>Last sweep that was done</h3>
      <p>{states[kept.state]}</p>
      {kept.state === "kept" && (
        <>
          <p>
            Axis {kept.axis}, ended {kept.ended} by {words(kept.end ?? "")}.{" "}
            <a href={CSV_PATH} download>
              The file, with its checksum (CSV)
            </a>
          </p>
          <KeptCurve kept={kept.points} />
        </>
      )}
    </>
  );
}

function runCurves(runs: readonly SweepRun[], axis: Axis): Curve[] {
  const range = axis.maximum - axis.minimum;
  const unitPerTick = range / (axis.maximum_ticks - axis.minimum_ticks);
  const curve = (way: "upwards" | "downwards"): GraphPoint[] =>
    runs.flatMap(({ hertz, [way]: ticks }) =>
      ticks === null ? [] : [[hertz, Math.abs(ticks * unitPerTick)] as const],
    );
  return [
    { name: "upwards", kind: "first", points: curve("upwards") },
    { name: "downwards", kind: "second", points: curve("downwards") },
  ];
}

/** The log reports the present run; its speeds are known once it is done. */
function PresentSweep({ page, axis }: { page: Page; axis: Axis }) {
  const [log] = useAnswer(page, LOG_PATH, Log, ASK_AGAIN_MS);
  const entries = log?.entries ?? [];
  const curves = runCurves(readRuns(entries), axis);
  return (
    <>
      <h3>Present sweep</h3>
      <p>{entries.at(-1)?.text}</p>
      <GraphLegend curves={curves} />
      <Graph
        label="Degrees in a run by frequency"
        curves={curves}
        x={kilohertz}
        y={(value) => `${formatNumber(value, 0)} °`}
      />
    </>
  );
}

/** Which axis, that it is free, and the sweep of it. */
function SweepOrder({
  axis,
  able,
  choose,
  isFree,
  setIsFree,
  commanding,
  refusal,
}: {
  axis: Axis;
  able: readonly Axis[];
  choose: (name: string) => void;
  isFree: boolean;
  setIsFree: (isFree: boolean) => void;
  commanding: ModePanelProperties["commanding"];
  refusal: string | null;
}) {
  return (
    <div className="orders">
      <label>
        Axis{" "}
        <select
          value={axis.name}
          onChange={(event) => choose(event.target.value)}
        >
          {able.map(({ name }) => (
            <option key={name}>{name}</option>
          ))}
        </select>
      </label>
      <label>
        <input
          type="checkbox"
          checked={isFree}
          onChange={(event) => setIsFree(event.target.checked)}
        />{" "}
        I have looked: {axis.name} is free, nothing hinders it, and nobody is at
        it
      </label>
      <Order
        commanding={commanding}
        path={commands.SWEEP.path}
        fields={{ axis: axis.name, is_free: true }}
        refusal={refusal ?? (isFree ? null : "Confirm that the axis is free.")}
      >
        {commands.SWEEP.label} {axis.name}
      </Order>
    </div>
  );
}

/**
 * The speeds of an axis by frequency: measured once the user has confirmed that it is free, and shown as they come.
 *
 * @satisfies SWR-CON-035
 */
export function Sweep({
  robot,
  operation,
  commanding,
  outlook,
}: ModePanelProperties) {
  const [kept] = useAnswer(operation.page, PATH, Kept, ASK_AGAIN_MS);
  const [isFree, setIsFree] = useState(false);
  const [chosen, setChosen] = useState<string | null>(null);
  const { status, motors } = robot;
  const able = motors.axes.filter(({ name }) =>
    status.cards.some(
      (card) => card.axis === name && card.type === "high_frequency",
    ),
  );
  const axis = able.find(({ name }) => name === chosen) ?? able[0];
  const isRunning = status.mode.name === "SWEEP" && status.order !== "none";
  return (
    <>
      {axis !== undefined && (
        <SweepOrder
          axis={axis}
          able={able}
          choose={(name) => {
            setChosen(name);
            setIsFree(false);
          }}
          isFree={isFree}
          setIsFree={setIsFree}
          commanding={commanding}
          refusal={reasonAgainst(outlook, "SWEEP")}
        />
      )}
      {axis === undefined && <p>No card of this robot makes waves.</p>}
      <div className="sweep">
        {axis !== undefined && isRunning && (
          <PresentSweep page={operation.page} axis={axis} />
        )}
        <KeptSweep kept={kept} />
      </div>
    </>
  );
}
