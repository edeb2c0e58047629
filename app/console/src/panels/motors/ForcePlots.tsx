// SPDX-License-Identifier: Apache-2.0
import type { Needle } from "@interface";
import { saveText } from "../../words/download";
import { formatNumber, formatValue, words } from "../../words/format";
import type { Newtons, Trace } from "../../words/trace";
import { Figure, rangeOf } from "./Plot";
import { overTime, PlotTools, useShown, whenOf, type Shown } from "./PlotTools";

const channels = [
  { look: "hand", label: "hand", channel: "HAND" },
  { look: "needle", label: "needle", channel: "NEEDLE", dash: "8 5" },
] as const;

function newtons(force: number | undefined): string {
  return force === undefined ? "doubtful" : `${formatNumber(force, 2)} N`;
}

/** The name of the needle's place, by the point from which it is counted. */
function placeOf({ hasDepth }: Trace): string {
  return hasDepth ? "depth below the entry point" : "position of the axis";
}

/** The force of each channel. */
function Forces({ forces }: { forces: Newtons }) {
  return channels.map(({ label, channel }) => (
    <span key={channel}>
      {label} {newtons(forces.get(channel))}
    </span>
  ));
}

function Reading({ needle, plots }: { needle: Needle; plots: Shown }) {
  const values = plots.shown.at(needle.axis, plots.agoS ?? 0);
  if (values === null) {
    return <p className="plot-reading">No data.</p>;
  }
  return (
    <p className="plot-reading">
      <span>{whenOf(plots, values.agoS)}</span>
      <Forces forces={values.forces} />
      <span>
        {placeOf(plots.shown)}{" "}
        {values.isKnown
          ? formatValue(plots.shown.depthOf(values.position), needle.unit)
          : "not known"}
      </span>
    </p>
  );
}

/**
 * Forces of hand and needle in the last 30 s, over time with the depth below, and over the depth with the
 * membranes. The depth counts from the entry point, as membranes do; before an insertion by hand has shown where that
 * is, there are positions of the axis in its place.
 *
 * @satisfies SWR-CON-610
 * @satisfies SWR-CON-700
 * @satisfies SWR-CON-750
 * @satisfies SWR-CON-754
 */
export function ForcePlots({
  needle,
  trace,
}: {
  needle: Needle;
  trace: Trace;
}) {
  const plots = useShown(trace);
  const { shown, agoS, setCursor } = plots;
  const depths = shown.depths(needle.axis);
  const place = placeOf(shown);
  const forces = channels.map(({ channel, ...curve }) => ({
    ...curve,
    values: shown.force(channel),
  }));
  const time = {
    places: shown.times(),
    across: overTime,
    unit: "s",
    cursor: agoS === null ? null : -agoS,
    onCursor: setCursor,
  };
  const marks = shown.membranes().map((mark) => {
    const look = words(mark.state).toLowerCase();
    const label =
      mark.state === "UNEXPECTED" ? "unexpected puncture" : `membrane ${look}`;
    return { look, label, place: mark.place };
  });
  const there = agoS === null ? null : shown.at(needle.axis, agoS);
  return (
    <>
      <PlotTools
        plots={plots}
        isEmpty={shown.length === 0}
        onSave={() =>
          saveText("force.csv", "text/csv", shown.forceCsv(needle.axis))
        }
      />
      <Reading needle={needle} plots={plots} />
      <div className="plots-kinds">
        <Figure title="Force over time, N" curves={forces} {...time} />
        <Figure
          title={`Force over the ${place}, N`}
          curves={forces}
          places={depths}
          across={rangeOf([depths, marks.map(({ place }) => place)])}
          unit={needle.unit}
          cursor={there?.isKnown ? shown.depthOf(there.position) : null}
          marks={marks}
        />
        <Figure
          title={`The ${place} over time, ${needle.unit}`}
          curves={[{ look: "depth", label: place, values: depths }]}
          {...time}
        />
      </div>
    </>
  );
}
