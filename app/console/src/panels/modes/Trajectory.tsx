// SPDX-License-Identifier: Apache-2.0
import { useMemo } from "react";
import { Trajectory as Held } from "@interface";
import type { Path } from "@interface";
import { formatNumber } from "../../words/format";
import { useList } from "../../state/lists";
import { useKept } from "../../state/operation";
import { reasonAgainst } from "../../state/outlook";
import { Check, HeldName, ListOrders } from "../../parts/Check";
import { FileDrop, type TextFile } from "../../parts/FileDrop";
import { Graph } from "../../parts/drawn/Graph";
import {
  lineOf,
  readTrajectory,
  type TrajectoryTable,
} from "../../words/trajectory_table";
import type { ModePanelProperties } from "./mode_panel";

const PATH: Path = "/api/v1/trajectory";

function seconds(value: number): string {
  return `${formatNumber(value, 1)} s`;
}

function Preview({ table }: { table: TrajectoryTable }) {
  return (
    <ul className="ways">
      {table.ways.map(({ axis, unit, points }) => (
        <li key={axis}>
          <h3>
            {axis} ({unit})
          </h3>
          <Graph
            label={`Way of ${axis} over time`}
            curves={[{ name: axis, kind: "first", points }]}
            x={seconds}
            y={(value) => formatNumber(value, 1)}
          />
        </li>
      ))}
    </ul>
  );
}

function HeldNote({ held }: { held: Held | null }) {
  if (held === null) {
    return <p>Which trajectory is held is not known yet.</p>;
  }
  if (held.rows === 0) {
    return <p>No trajectory is held.</p>;
  }
  return (
    <p>
      Held: {held.rows} rows, <HeldName held={held} />.{" "}
      {held.time_s > 0 &&
        `When it was run last it came to row ${held.row + 1}, at ${seconds(held.time_s)}.`}
    </p>
  );
}

/**
 * A table from a file: looked at here, judged by control, run by its checksum.
 *
 * @satisfies SWR-CON-034
 */
export function Trajectory({
  operation,
  commanding,
  outlook,
}: ModePanelProperties) {
  const list = useList(operation, PATH, Held);
  const [file, setFile] = useKept<TextFile | null>(operation, "table", null);
  const text = file?.text ?? "";
  const table = useMemo(() => readTrajectory(text), [text]);
  const pointer =
    list.verdict?.state === "refused"
      ? list.verdict.problem.pointer
      : undefined;
  return (
    <>
      <FileDrop
        label="Choose a table (CSV)…"
        accept=".csv,text/csv"
        take={(taken) => {
          setFile(taken);
          list.forget();
        }}
      />
      {file !== null && (
        <p>
          <strong>{file.name}</strong>
          {table === null
            ? ": nothing can be drawn of it; send it to learn why."
            : `: ${table.rows} rows, ${seconds(table.durationS)}.`}
          {list.isOurs && " It is the one that is held."}
        </p>
      )}
      {table !== null && <Preview table={table} />}
      <ListOrders
        commanding={commanding}
        list={list}
        run="RUN_TRAJECTORY"
        refusal={reasonAgainst(outlook, "TRAJECTORY")}
        missing={file === null ? "Choose a table first." : null}
        send={() => list.send(text, "text/csv")}
      />
      <Check verdict={list.verdict} quote={lineOf(text, pointer)} />
      <HeldNote held={list.held} />
    </>
  );
}
