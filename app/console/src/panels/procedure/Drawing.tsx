// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState, type RefObject } from "react";
import type { Robot, RobotState, Targeting } from "@interface";
import { formatNumber, formatPoint } from "../../words/format";
import { useRobot } from "../../state/outlook";
import type { Page } from "../../state/page";
import {
  drawingOf,
  pointsOf,
  sceneOf,
  type Line,
  type DrawnNeedle,
  type Point,
  type Scene,
} from "../../state/scene";
import "./Drawing.css";

/** Around what is drawn, in pixels, for letters. */
const MARGIN = 34;
const HIGHEST = 380;
/** Before the page says how wide it is. */
const USUAL_WIDTH = 480;
/** The size of the drawing is rounded up to so many millimetres, so that the scale seldom changes. */
const STEP_MM = 20;
const BAR_LENGTHS_MM = [200, 100, 50, 20, 10, 5];
const BAR_SHARE = 0.3;

type Index = 0 | 1 | 2;

interface Direction {
  title: string;
  right: Index;
  up: Index;
}

/** With the last axis to the right, as it runs along the bore: from the left, and from above. */
const SIDE: Direction = { title: "Side view", right: 2, up: 1 };
const TOP: Direction = { title: "Top view", right: 2, up: 0 };

/** The least and the most of each coordinate. */
interface Box {
  low: Point;
  high: Point;
}

function rounded(points: readonly Point[]): Box {
  const of = (index: Index) => points.map((point) => point[index]);
  const low = (index: Index) =>
    Math.floor(Math.min(...of(index)) / STEP_MM) * STEP_MM;
  const high = (index: Index) =>
    Math.ceil(Math.max(...of(index)) / STEP_MM) * STEP_MM;
  return { low: [low(0), low(1), low(2)], high: [high(0), high(1), high(2)] };
}

/** Points that have been drawn keep their room, so that the size of the drawing does not change to and fro. */
function useBox(points: readonly Point[]): Box {
  const [box, setBox] = useState(() => rounded(points));
  const wanted = rounded([...points, box.low, box.high]);
  if (JSON.stringify(wanted) !== JSON.stringify(box)) {
    setBox(wanted);
  }
  return wanted;
}

function useWidth(): [RefObject<HTMLDivElement | null>, number] {
  const ref = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(USUAL_WIDTH);
  useEffect(() => {
    if (ref.current === null || !("ResizeObserver" in window)) {
      return;
    }
    const observer = new ResizeObserver(([entry]) => {
      setWidth(entry?.contentRect.width ?? USUAL_WIDTH);
    });
    observer.observe(ref.current);
    return () => observer.disconnect();
  }, []);
  return [ref, width];
}

function size(box: Box, index: Index): number {
  return box.high[index] - box.low[index];
}

/** Pixels of a millimetre, the same in both views. */
function scaleOf(box: Box, width: number): number {
  const across = (width - 2 * MARGIN) / size(box, SIDE.right);
  const upwards = HIGHEST / Math.max(size(box, SIDE.up), size(box, TOP.up));
  return Math.max(0.1, Math.min(across, upwards));
}

/** From millimetres to pixels of a view. */
type Projection = (point: Point) => [x: number, y: number];

function path(points: readonly Point[], to: Projection): string {
  return points.map((point) => to(point).join(" ")).join(" ");
}

function Part({ line, to }: { line: Line; to: Projection }) {
  return (
    <g className="drawing-part">
      <title>{line.name}</title>
      <polyline points={path(line.points, to)} />
      {line.points.map((point, index) => {
        const [x, y] = to(point);
        return <circle key={index} cx={x} cy={y} r="3" />;
      })}
    </g>
  );
}

/** The z-frame: its axes from its origin. */
function Frame({ points, to }: { points: readonly Point[]; to: Projection }) {
  const [origin, ...ends] = points;
  if (origin === undefined) {
    return null;
  }
  const [x, y] = to(origin);
  return (
    <g className="drawing-frame" data-mark="frame">
      {ends.map((end, index) => (
        <polyline key={index} points={path([origin, end], to)} />
      ))}
      <text x={x} y={y + 18}>
        z-frame
      </text>
    </g>
  );
}

/** Which axis goes to the right, and which up. */
function Compass({ right, up, y }: { right: string; up: string; y: number }) {
  return (
    <g className="drawing-compass" transform={`translate(10 ${y})`}>
      <path d="M0-26V0H26M-4-20L0-26 4-20M20-4L26 0 20 4" />
      <text x="32" y="5">
        {right}
      </text>
      <text x="0" y="-32" textAnchor="middle">
        {up}
      </text>
    </g>
  );
}

function NeedleLine({ needle, to }: { needle: DrawnNeedle; to: Projection }) {
  const [x, y] = to(needle.treatment);
  return (
    <g className="drawing-needle">
      {needle.rear !== null && needle.tip !== null && (
        <polyline points={path([needle.rear, needle.tip], to)} />
      )}
      <path
        data-mark="treatment"
        transform={`translate(${x} ${y})`}
        d="M0-6L6 0 0 6-6 0z"
      />
    </g>
  );
}

/** An entry is a square on the left of its word, a target a circle with a cross on the right of its. */
function Marks({ scene, to }: { scene: Scene; to: Projection }) {
  const entry = scene.entry && to(scene.entry);
  const target = scene.target && to(scene.target);
  const start = scene.needle && to(scene.needle.treatment);
  return (
    <>
      {start !== null && target !== null && (
        <line
          className="drawing-distance"
          x1={start[0]}
          y1={start[1]}
          x2={target[0]}
          y2={target[1]}
        />
      )}
      {entry !== null && (
        <g
          className="drawing-entry"
          data-mark="entry"
          transform={`translate(${entry.join(" ")})`}
        >
          <path d="M-5-5h10v10h-10z" />
          <text x="-10" y="5" textAnchor="end">
            Entry
          </text>
        </g>
      )}
      {target !== null && (
        <g
          className="drawing-target"
          data-mark="target"
          transform={`translate(${target.join(" ")})`}
        >
          <path d="M7 0A7 7 0 1 1-7 0 7 7 0 1 1 7 0zM-11 0h22M0-11v22" />
          <text x="15" y="5">
            Target
          </text>
        </g>
      )}
    </>
  );
}

function ScaleBar({ scale, width }: { scale: number; width: number }) {
  const most = width * BAR_SHARE;
  const length = BAR_LENGTHS_MM.find((mm) => mm * scale <= most) ?? 5;
  return (
    <g
      className="drawing-scale"
      data-mm={length}
      transform={`translate(${width - MARGIN - length * scale} 22)`}
    >
      <path d={`M0-5v5h${length * scale}v-5`} />
      <text x={(length * scale) / 2} y="-8" textAnchor="middle">
        {length} mm
      </text>
    </g>
  );
}

interface ViewProperties {
  scene: Scene;
  box: Box;
  direction: Direction;
  width: number;
  scale: number;
}

function View({ scene, box, direction, width, scale }: ViewProperties) {
  const { title, right, up } = direction;
  const height = size(box, up) * scale + 2 * MARGIN;
  const left = (width - size(box, right) * scale) / 2;
  const to: Projection = (point) => [
    left + (point[right] - box.low[right]) * scale,
    MARGIN + (box.high[up] - point[up]) * scale,
  ];
  const axes = `${scene.axes[right]} to the right, ${scene.axes[up]} up`;
  return (
    <figure>
      <figcaption>
        {title}: {axes}
      </figcaption>
      <svg
        role="img"
        aria-label={`${title}, ${axes}. Its contents are listed beside it.`}
        viewBox={`0 0 ${width} ${height}`}
        width="100%"
        height={height}
      >
        <Frame points={scene.frame} to={to} />
        {scene.parts.map((line) => (
          <Part key={line.name} line={line} to={to} />
        ))}
        {scene.needle !== null && <NeedleLine needle={scene.needle} to={to} />}
        <Marks scene={scene} to={to} />
        <ScaleBar scale={scale} width={width} />
        <Compass
          right={scene.axes[right]}
          up={scene.axes[up]}
          y={height - 10}
        />
      </svg>
    </figure>
  );
}

function Views({ scene }: { scene: Scene }) {
  const box = useBox(pointsOf(scene));
  const [ref, width] = useWidth();
  const scale = scaleOf(box, width);
  const common = { scene, box, width, scale };
  return (
    <>
      <div ref={ref}>
        <View {...common} direction={SIDE} />
      </div>
      <div>
        <View {...common} direction={TOP} />
      </div>
    </>
  );
}

function pointText(point: Point | null | undefined, otherwise: string): string {
  return point ? formatPoint(point) : otherwise;
}

/** Points in scanner coordinates stand nowhere while the scanner is not registered. */
function planText(point: Point | null, isThere: boolean): string {
  return pointText(point, isThere ? "not drawn without registration" : "none");
}

function missingText({ missing }: Scene, hasDrawing: boolean | null): string {
  if (hasDrawing === null) {
    return "the body: not known yet which robot it is";
  }
  if (!hasDrawing) {
    return "the body: this page has no drawing of this robot's file";
  }
  return missing.length === 0
    ? "–"
    : `${missing.join(", ")}: an axis is not homed`;
}

interface FactsProperties {
  scene: Scene;
  targeting: Targeting;
  /** Null while it is not known. */
  hasDrawing: boolean | null;
}

function Facts({ scene, targeting, hasDrawing }: FactsProperties) {
  const { needle } = scene;
  const { distance_mm: distance } = targeting;
  const unknown = "unknown until all axes are homed";
  return (
    <dl className="facts">
      <dt>Coordinates</dt>
      <dd>
        {scene.isRegistered
          ? "scanner: R, A, S in mm"
          : "z-frame of the robot, mm; not registered"}
      </dd>
      <dt>Treatment point ◆</dt>
      <dd>{pointText(needle?.treatment, unknown)}</dd>
      <dt>Needle tip</dt>
      <dd>{pointText(needle?.tip, needle === null ? unknown : "unknown")}</dd>
      <dt>Entry point □</dt>
      <dd>{planText(scene.entry, targeting.entry_mm !== null)}</dd>
      <dt>Target ⊕</dt>
      <dd>{planText(scene.target, targeting.target !== null)}</dd>
      <dt>Treatment point to target</dt>
      <dd>{distance === null ? "–" : `${formatNumber(distance, 2)} mm`}</dd>
      <dt>Angle to the target’s line</dt>
      <dd>
        {needle?.angle == null ? "–" : `${formatNumber(needle.angle, 1)}°`}
      </dd>
      <dt>Not drawn</dt>
      <dd>{missingText(scene, hasDrawing)}</dd>
    </dl>
  );
}

/** `described`: what does not change of the robot; null while it is not known. */
export function DrawnRobot({
  robot,
  described,
}: {
  robot: RobotState;
  described: Robot | null;
}) {
  const drawing = drawingOf(described);
  const scene = sceneOf(robot, drawing);
  const { targeting } = robot;
  return (
    <div className="drawing">
      <Views
        key={`${drawing?.checksum} ${targeting.registration?.join(" ")}`}
        scene={scene}
      />
      <Facts
        scene={scene}
        targeting={targeting}
        hasDrawing={described && drawing !== null}
      />
    </div>
  );
}

export interface DrawingProperties {
  robot: RobotState;
  page: Page;
}

/**
 * The robot to scale, from its file, and what it aims at.
 *
 * @satisfies SWR-CON-029
 * @satisfies SWR-CON-030
 */
export function Drawing({ robot, page }: DrawingProperties) {
  const described = useRobot(page, robot.status.boot_id);
  return <DrawnRobot robot={robot} described={described} />;
}
