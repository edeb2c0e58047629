// SPDX-License-Identifier: Apache-2.0
import type { Box, BoxNeedle as Needle, BoxPoint } from "@interface";
import type { BoxHands } from "../../state/box";
import { formatNumber } from "../../words/format";
import { NumberChoice, type NumberChoiceProperties } from "./Choice";
import "./BoxNeedle.css";

type Across = "x_mm" | "y_mm";

/** As the views of the robot: the needle goes to the right. */
const views: { name: string; up: Across }[] = [
  { name: "From the side, y upwards", up: "y_mm" },
  { name: "From above, x upwards", up: "x_mm" },
];
/** The least depth that is drawn, and the steps in which the drawing grows. */
const STEP_MM = 20;
const AHEAD_MM = 60;
const MARGIN_MM = 4;

function up(mm: number): number {
  return Math.ceil(mm / STEP_MM) * STEP_MM;
}

interface Range {
  depth: number;
  across: number;
}

function rangeOf(needle: Needle): Range {
  const { way, target, image, surface_mm } = needle;
  const points = [...way, target, image?.place ?? null].filter(
    (point) => point !== null,
  );
  return {
    depth: up(
      Math.max(
        surface_mm + AHEAD_MM,
        ...points.map((point) => point.depth_mm + MARGIN_MM),
      ),
    ),
    across: up(
      Math.max(
        ...points.map(({ x_mm, y_mm }) =>
          Math.max(Math.abs(x_mm), Math.abs(y_mm)),
        ),
        1,
      ),
    ),
  };
}

function at(point: BoxPoint, across: Across): [number, number] {
  return [point.depth_mm, -point[across]];
}

function View({
  needle,
  range,
  name,
  across,
}: {
  needle: Needle;
  range: Range;
  name: string;
  across: Across;
}) {
  const { way, target, image, surface_mm } = needle;
  const high = range.across + MARGIN_MM;
  return (
    <figure>
      <svg
        role="img"
        aria-label={`Simulated truth, ${name.toLowerCase()}`}
        viewBox={`${-MARGIN_MM} ${-high} ${range.depth + 2 * MARGIN_MM} ${2 * high}`}
      >
        <rect
          className="needle-tissue"
          x={surface_mm}
          y={-high}
          width={Math.max(0, range.depth + MARGIN_MM - surface_mm)}
          height={2 * high}
        />
        <line className="needle-line" x1={0} x2={range.depth} y1={0} y2={0} />
        <polyline
          className="needle-way"
          points={way.map((point) => at(point, across).join(" ")).join(" ")}
        />
        {target !== null && (
          <path
            className="needle-target"
            data-mark="target"
            transform={`translate(${at(target, across).join(" ")})`}
            d="M3 0A3 3 0 1 1-3 0 3 3 0 1 1 3 0zM-5 0h10M0-5v10"
          />
        )}
        {image !== null && (
          <path
            className="needle-image"
            data-mark="image"
            transform={`translate(${at(image.place, across).join(" ")})`}
            d="M-2-2L2 2M-2 2L2-2"
          />
        )}
      </svg>
      <figcaption>{name}</figcaption>
    </figure>
  );
}

function placeText({ x_mm, y_mm, depth_mm }: BoxPoint): string {
  const [x, y, depth] = [x_mm, y_mm, depth_mm].map((mm) => formatNumber(mm, 2));
  return `x ${x} mm, y ${y} mm, depth ${depth} mm`;
}

function distanceText(a: BoxPoint, b: BoxPoint): string {
  const mm = Math.hypot(
    a.x_mm - b.x_mm,
    a.y_mm - b.y_mm,
    a.depth_mm - b.depth_mm,
  );
  return `${formatNumber(mm, 2)} mm from the tip`;
}

function Facts({ needle }: { needle: Needle }) {
  const { way, target, image } = needle;
  const tip = way.at(-1);
  return (
    <dl className="needle-facts">
      <dt>Tip</dt>
      <dd>{tip === undefined ? "" : placeText(tip)}</dd>
      <dt>Base</dt>
      <dd>
        turned by {formatNumber(needle.turn_deg, 1)} degrees,{" "}
        {formatNumber(needle.lag_deg, 1)} ahead of the tip
      </dd>
      <dt>Target</dt>
      <dd>
        {target === null || tip === undefined
          ? "none"
          : `${placeText(target)}, ${distanceText(target, tip)}`}
      </dd>
      <dt>Image</dt>
      <dd>
        {image === null
          ? "none yet"
          : `${image.number}, ${formatNumber(image.age_ms / 1000, 1)} s old, ${placeText(image.place)}`}
      </dd>
    </dl>
  );
}

interface NeedleProperties {
  hands: BoxHands;
  needle: Needle;
  isDisabled: boolean;
}

function msText(ms: number): string {
  return `${ms / 1000} s`;
}

type NumberOfNeedle =
  | "curvature"
  | "torsion_deg"
  | `images_${"period_ms" | "delay_ms" | "noise_um"}`;

/** Numbers that can be chosen, each with the order that changes it. */
const choices: (Pick<
  NumberChoiceProperties,
  "name" | "order" | "numbers" | "text"
> & { of: NumberOfNeedle })[] = [
  {
    name: "Curvature",
    of: "curvature",
    order: "needle_curvature",
    numbers: [0, 1000, 2200, 4100, 8000],
    text: (value) => `${value / 1_000_000} per mm`,
  },
  {
    name: "Torsion",
    of: "torsion_deg",
    order: "needle_torsion",
    numbers: [0, 20, 45],
    text: (value) => `${value} degrees per 100 mm`,
  },
  {
    name: "Images",
    of: "images_period_ms",
    order: "images_period_ms",
    numbers: [0, 500, 1000, 2000, 5000],
    text: (value) => (value === 0 ? "none" : `each ${msText(value)}`),
  },
  {
    name: "Delay of images",
    of: "images_delay_ms",
    order: "images_delay_ms",
    numbers: [0, 200, 500, 2000],
    text: msText,
  },
  {
    name: "Noise of images",
    of: "images_noise_um",
    order: "images_noise_um",
    numbers: [0, 300, 500, 1000],
    text: (value) => `${value / 1000} mm`,
  },
];

function Choices({ hands, needle, isDisabled }: NeedleProperties) {
  const hasTarget = needle.target !== null;
  return (
    <div className="box-groups">
      {choices.map(({ of, ...choice }) => (
        <NumberChoice
          key={of}
          {...choice}
          hands={hands}
          value={needle[of]}
          isDisabled={isDisabled}
        />
      ))}
      <div className="box-group">
        <button
          type="button"
          disabled={isDisabled}
          onClick={() =>
            void hands.order({ target: hasTarget ? "none" : "usual" })
          }
        >
          {hasTarget ? "Take target away" : "Put a moving target there"}
        </button>
      </div>
    </div>
  );
}

/**
 * The needle as it truly is in simulated tissue, which no controller knows; where there is tissue.
 *
 * @satisfies SWR-BOX-778
 */
export function BoxNeedle({
  hands,
  box: { needle },
  isDisabled,
}: {
  hands: BoxHands;
  box: Pick<Box, "needle">;
  isDisabled: boolean;
}) {
  if (needle === null) {
    return null;
  }
  const range = rangeOf(needle);
  return (
    <details className="box-needle">
      <summary>Needle in tissue: truth of the simulation</summary>
      <p>
        The simulated needle as it is: no controller knows it. The dashed line
        is a needle that is not bent, shaded is tissue, a cross is the newest
        image of the tip, a circle the target.
      </p>
      <div className="needle-views">
        {views.map((view) => (
          <View
            key={view.up}
            needle={needle}
            range={range}
            name={view.name}
            across={view.up}
          />
        ))}
      </div>
      <Facts needle={needle} />
      <Choices hands={hands} needle={needle} isDisabled={isDisabled} />
    </details>
  );
}
