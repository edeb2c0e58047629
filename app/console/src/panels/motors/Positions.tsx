// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";
import { commands, PositionsPreview } from "@interface";
import type {
  Path,
  PreviewAxis,
  Problem,
  RobotState,
  SavedPositions,
} from "@interface";
import { saveText } from "../../words/download";
import { formatValue, words } from "../../words/format";
import { isKnown } from "../../state/trust";
import {
  useCommanding,
  type Commanding,
  type Operation,
} from "../../state/operation";
import { refusalOf, type Page } from "../../state/page";
import { fitted } from "../../words/shape";
import { FileDrop, type TextFile } from "../../parts/FileDrop";
import { OrderNotes } from "../../parts/Order";
import { Twice } from "../../parts/Twice";
import "./Positions.css";

const POSITIONS_PATH: Path = "/api/v1/positions";
const PREVIEW_PATH: Path = "/api/v1/positions/preview";
const NO_ANSWER = "The server does not answer.";

const whys: Readonly<Record<PreviewAxis["why"], string>> = {
  counts_agree: "Its counter stands as it was saved.",
  other_power_on: "The box was switched off since.",
  unsealed: "Nobody has sealed the file.",
  old_list: "A list of the older program: neither robot nor time is known.",
  miscounted: "You say that it has not moved: its counts are wrong.",
  moved: "Its counter has moved since.",
  not_known: "Its position was not known when it was saved.",
  stands_there: "It is homed, and there.",
};

const origins: Readonly<Record<PositionsPreview["origin"], string>> = {
  sealed: "Sealed by this box",
  unsealed: "Sealed by nobody",
  old_list: "A list of the older program",
};

/** The preview, and the request that it belongs to. */
interface Seen extends PositionsPreview {
  file: TextFile;
}

/** The name of the reason stands in front: it is what the manual lists. */
function reported(problem: Partial<Problem>): string {
  const { code } = problem;
  return `${code === undefined ? "" : `${code}: `}${refusalOf(problem)}`;
}

async function save(page: Page): Promise<string | null> {
  const response = await page.request("GET", POSITIONS_PATH);
  const text = await response.text();
  if (!response.ok) {
    return reported(JSON.parse(text) as Problem);
  }
  const { robot, saved_utc: utc } = JSON.parse(text) as SavedPositions;
  const name = `positions-${robot}-${utc.replaceAll(":", "-")}.json`;
  saveText(name, "application/json", text);
  return null;
}

/** A list of motors is what the older control program has saved. */
function bodyOf(text: string, miscounted: readonly string[]): string {
  const saved = JSON.parse(text) as unknown;
  return JSON.stringify({
    ...(Array.isArray(saved) ? { motors: saved } : { file: saved }),
    ...(miscounted.length > 0 && { miscounted }),
  });
}

async function look(
  page: Page,
  text: string,
  miscounted: readonly string[],
): Promise<PositionsPreview | string> {
  let body: string;
  try {
    body = bodyOf(text, miscounted);
  } catch {
    return "This file is no JSON.";
  }
  const response = await page.request("POST", PREVIEW_PATH, body);
  const answer = (await response.json()) as PositionsPreview | Problem;
  return "detail" in answer
    ? reported(answer)
    : fitted(answer, PositionsPreview, PREVIEW_PATH);
}

/** Looks again, with this axis where it was saved. */
type Correct = (name: string) => void;

interface RowProperties {
  axis: PreviewAxis;
  /** Where it stands now. */
  isKnown: boolean;
  correct: Correct;
}

function Row({ axis, isKnown, correct }: RowProperties) {
  const value = (number: number) => formatValue(number, axis.unit);
  const now = (number: number) => (isKnown ? value(number) : "unknown");
  return (
    <tr data-restored={axis.is_restored}>
      <th scope="row">{axis.name}</th>
      <td className="number">{value(axis.saved)}</td>
      <td className="number">{now(axis.now)}</td>
      <td className="number">{now(axis.delta)}</td>
      <td>{axis.is_restored ? "restored" : "stays"}</td>
      <td>{words(axis.grade)}</td>
      <td>
        {whys[axis.why]}
        {axis.why === "moved" && (
          <>
            {" "}
            <button type="button" onClick={() => correct(axis.name)}>
              It has not moved
            </button>
          </>
        )}
      </td>
    </tr>
  );
}

interface DifferencesProperties {
  preview: PositionsPreview;
  /** The names of the axes that stand somewhere known. */
  known: readonly string[];
  correct: Correct;
}

function Differences({ preview, known, correct }: DifferencesProperties) {
  return (
    <div
      className="positions-table"
      role="region"
      aria-label="Differences"
      tabIndex={0}
    >
      <table>
        <caption>
          {origins[preview.origin]}
          {preview.saved_utc !== null && `, saved ${preview.saved_utc}`}.{" "}
          {preview.is_same_power_on
            ? "The box was not switched off since."
            : "The box may have been switched off since."}
        </caption>
        <thead>
          <tr>
            <th scope="col">Axis</th>
            <th scope="col" className="number">
              Saved
            </th>
            <th scope="col" className="number">
              Now
            </th>
            <th scope="col" className="number">
              Difference
            </th>
            <th scope="col">It is</th>
            <th scope="col">Trusted as</th>
            <th scope="col">Why</th>
          </tr>
        </thead>
        <tbody>
          {preview.axes.map((axis) => (
            <Row
              key={axis.name}
              axis={axis}
              isKnown={known.includes(axis.name)}
              correct={correct}
            />
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Preview({
  preview,
  known,
  correct,
  commanding,
  onEnd,
}: DifferencesProperties & {
  commanding: Commanding;
  onEnd: (isDone: boolean) => void;
}) {
  const names = preview.axes
    .filter(({ is_restored }) => is_restored)
    .map(({ name }) => name);
  return (
    <>
      <Differences preview={preview} known={known} correct={correct} />
      <div className="orders">
        {names.length === 0 ? (
          <p>There is no axis to restore.</p>
        ) : (
          <Twice
            question={`Restore ${names.join(", ")}, and forget the target?`}
            commanding={commanding}
            path={commands.RESTORE.path}
            fields={{ token: preview.token }}
            onDone={() => onEnd(true)}
          >
            Apply
          </Twice>
        )}
        <button type="button" onClick={() => onEnd(false)}>
          Leave as it is
        </button>
        {names.length > 0 && (
          <p className="orders-refusal">
            Applied within {preview.left_s} s, while nothing moves, or looked at
            again.
          </p>
        )}
      </div>
    </>
  );
}

/** The positions that a file would restore, and the note on the last attempt. */
function usePreview(operation: Operation) {
  const [preview, setPreview] = useState<Seen | null>(null);
  const [note, setNote] = useState<string | null>(null);
  const attempt = (work: () => Promise<string | null>) =>
    void work()
      .catch(() => NO_ANSWER)
      .then(setNote);
  const take = (file: TextFile, miscounted: readonly string[] = []) =>
    attempt(async () => {
      setPreview(null);
      const found = await look(operation.page, file.text, miscounted);
      if (typeof found === "string") {
        return `${file.name} was refused. ${found}`;
      }
      setPreview({ ...found, file });
      return null;
    });
  const correct = (name: string) => {
    if (preview !== null) {
      const before = preview.axes.filter(({ why }) => why === "miscounted");
      take(preview.file, [...before.map((axis) => axis.name), name]);
    }
  };
  const end = (isDone: boolean) => {
    setPreview(null);
    setNote(
      isDone
        ? "Restored and unverified: compare each axis with the robot, then hold the button at the box."
        : null,
    );
  };
  return { preview, note, attempt, take, correct, end };
}

/**
 * Saves where the axes stand, and restores it in two steps: what would become of each axis is looked at first.
 *
 * @satisfies SWR-CON-028
 * @satisfies SWR-CON-105
 */
export function Positions({
  robot,
  operation,
}: {
  robot: RobotState;
  operation: Operation;
}) {
  const commanding = useCommanding(operation, robot.status.authority);
  const known = robot.motors.axes.filter(isKnown).map(({ name }) => name);
  const { preview, note, attempt, take, correct, end } = usePreview(operation);
  return (
    <>
      <div className="orders">
        <button
          type="button"
          onClick={() => attempt(() => save(operation.page))}
        >
          Save positions
        </button>
      </div>
      <FileDrop
        label="Restore from a file…"
        accept=".json,application/json"
        take={take}
      />
      {note !== null && (
        <p className="order-problem" role="alert">
          {note}
        </p>
      )}
      {preview !== null && (
        <>
          <OrderNotes commanding={commanding} />
          <Preview
            key={preview.token}
            preview={preview}
            known={known}
            correct={correct}
            commanding={commanding}
            onEnd={end}
          />
        </>
      )}
    </>
  );
}
