// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";
import { Program as Held } from "@interface";
import type { Path } from "@interface";
import { formatNumber } from "../../words/format";
import { useList } from "../../state/lists";
import { useKept } from "../../state/operation";
import { reasonAgainst } from "../../state/outlook";
import { Check, HeldName, ListOrders } from "../../parts/Check";
import { FileDrop } from "../../parts/FileDrop";
import {
  emptyStep,
  readProgram,
  writeProgram,
  type StepText,
} from "../../words/program_table";
import type { ModePanelProperties } from "./mode_panel";

const PATH: Path = "/api/v1/program";

type Field = "depth" | "angle" | "dwell";

const fields: readonly (readonly [Field, string])[] = [
  ["depth", "Depth, mm"],
  ["angle", "Angle, °"],
  ["dwell", "Dwell, s"],
];

function StepRow({
  step,
  index,
  progress,
  change,
  remove,
}: {
  step: StepText;
  index: number;
  /** How far it has come in what is held, or null. */
  progress: string | null;
  change(step: StepText): void;
  remove(): void;
}) {
  const number = index + 1;
  return (
    <tr>
      <th scope="row">{number}</th>
      {fields.map(([field, label]) => (
        <td key={field}>
          <input
            aria-label={`${label} of step ${number}`}
            inputMode="decimal"
            size={7}
            value={step[field]}
            onChange={(event) =>
              change({ ...step, [field]: event.target.value })
            }
          />
        </td>
      ))}
      <td>
        <input
          type="checkbox"
          aria-label={`Gate of step ${number}`}
          checked={step.gate}
          onChange={(event) => change({ ...step, gate: event.target.checked })}
        />
      </td>
      <td>{progress}</td>
      <td>
        <button
          type="button"
          aria-label={`Remove step ${number}`}
          onClick={remove}
        >
          Remove
        </button>
      </td>
    </tr>
  );
}

/** Where the program that is held stands, for its step of this index. */
function progressOf(held: Held, index: number): string {
  if (index < held.done) {
    return "done";
  }
  return index === held.done && held.dwelt_s > 0
    ? `dwelt ${formatNumber(held.dwelt_s, 1)} s`
    : "";
}

/** @satisfies SWR-CON-130 */
function gateOf(held: Held): string {
  if (held.unread_inputs.some(({ name }) => name === "GATE")) {
    return "The gate is not read.";
  }
  const says = held.is_dose_reached ? "dose reached" : "go on";
  return `The gate says: ${held.is_treatment_stopped ? "stop" : says}.`;
}

function HeldNote({ held }: { held: Held | null }) {
  if (held === null) {
    return <p>Which program is held is not known yet.</p>;
  }
  const gate = gateOf(held);
  return (
    <p>
      {held.steps === 0 ? (
        "No treatment program is held."
      ) : (
        <>
          Held: {held.steps} steps, <HeldName held={held} />. Done: {held.done};
          the next one has dwelt {formatNumber(held.dwelt_s, 1)} s.
        </>
      )}{" "}
      {gate}
    </p>
  );
}

/** `held`: these steps, as they are held; null while they are not. */
function StepsTable({
  steps,
  held,
  show,
}: {
  steps: readonly StepText[];
  held: Held | null;
  show: (next: readonly StepText[]) => void;
}) {
  return (
    <div className="table-scroll" role="region" aria-label="Steps" tabIndex={0}>
      <table className="program">
        <thead>
          <tr>
            <th scope="col">Step</th>
            {fields.map(([field, label]) => (
              <th key={field} scope="col">
                {label}
              </th>
            ))}
            <th scope="col">Gate</th>
            <th scope="col">Progress</th>
            <th scope="col">
              <span className="hidden">Remove</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {steps.map((step, index) => (
            <StepRow
              key={index}
              step={step}
              index={index}
              progress={held === null ? null : progressOf(held, index)}
              change={(changed) => show(steps.with(index, changed))}
              remove={() => show(steps.toSpliced(index, 1))}
            />
          ))}
        </tbody>
      </table>
    </div>
  );
}

function StepsNote() {
  return (
    <p className="order-refusal">
      Depth is the position of the axis along the needle, angle that of the axis
      about it, each in its unit; a robot that does not turn its needle has no
      angle. With a gate a step ends when the dose is reached, at the latest
      after its dwell.
    </p>
  );
}

/**
 * Steps written here or read from a file, judged by control, run by their checksum.
 *
 * @satisfies SWR-CON-034
 */
export function Program({
  operation,
  commanding,
  outlook,
}: ModePanelProperties) {
  const list = useList(operation, PATH, Held);
  const [steps, setSteps] = useKept<readonly StepText[]>(operation, "steps", [
    emptyStep,
  ]);
  const [problem, setProblem] = useState<string | null>(null);
  const request = writeProgram(steps);
  const { held } = list;
  const show = (next: readonly StepText[]) => {
    setSteps(next);
    setProblem(null);
    list.forget();
  };
  return (
    <>
      <FileDrop
        label="Choose a program (JSON)…"
        accept=".json,application/json"
        take={({ name, text }) => {
          const read = readProgram(text);
          if (read === null) {
            setProblem(`${name} is no treatment program.`);
          } else {
            show(read);
          }
        }}
      />
      {problem !== null && (
        <p className="order-problem" role="alert">
          {problem}
        </p>
      )}
      <StepsTable steps={steps} held={list.isOurs ? held : null} show={show} />
      <p>
        <button type="button" onClick={() => show([...steps, emptyStep])}>
          Add a step
        </button>
      </p>
      <StepsNote />
      <ListOrders
        commanding={commanding}
        list={list}
        run="RUN_PROGRAM"
        refusal={reasonAgainst(outlook, "PROGRAM")}
        missing={request === null ? "A number is missing in a step." : null}
        send={() => list.send(JSON.stringify(request))}
      />
      <Check verdict={list.verdict} />
      <HeldNote held={held} />
    </>
  );
}
