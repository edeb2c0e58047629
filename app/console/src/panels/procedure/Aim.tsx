// SPDX-License-Identifier: Apache-2.0
import { useEffect, useId, useState } from "react";
import { TargetPreview } from "@interface";
import {
  commands,
  type Modes,
  type Path,
  type Problem,
  type RobotState,
} from "@interface";
import { RETRY_MS } from "../../state/answer";
import {
  formatNumber,
  formatOrigin,
  formatPoint,
  readAim,
  readNumbers,
} from "../../words/format";
import {
  useCommanding,
  type Commanding,
  type Operation,
} from "../../state/operation";
import { Matrix } from "../../parts/drawn/Matrix";
import { Order, OrderNotes } from "../../parts/Order";
import { reasonAgainst } from "../../state/outlook";
import { refusalOf, type Page } from "../../state/page";
import { fitted } from "../../words/shape";
import { MembraneOrder } from "./Membranes";
import { SteeringOrder } from "./Steering";

const PREVIEW_PATH: Path = "/api/v1/targeting/preview";
const PREVIEW_AFTER_MS = 300;

interface AimProperties {
  robot: RobotState;
  outlook: Modes | null;
  commanding: Commanding;
}

/** The field is empty until the user writes into it: the place of the robot is not guessed. */
function Registration({ outlook, commanding }: AimProperties) {
  const [text, setText] = useState("");
  const [ignores, setIgnores] = useState(false);
  const id = useId();
  const matrix = readNumbers(text, 16);
  const missing = matrix === null ? "Write 16 numbers, by rows, in mm." : null;
  return (
    <div className="orders">
      <label htmlFor={id}>Scanner from z-frame</label>
      <textarea
        id={id}
        rows={4}
        cols={32}
        value={text}
        onChange={(event) => setText(event.target.value)}
      />
      <label>
        <input
          type="checkbox"
          checked={ignores}
          onChange={(event) => setIgnores(event.target.checked)}
        />{" "}
        Only its translation
      </label>
      <Order
        commanding={commanding}
        path={commands.REGISTRATION.path}
        fields={{ matrix, ...(ignores && { ignore_rotation: true }) }}
        refusal={reasonAgainst(outlook, "REGISTRATION") ?? missing}
      >
        {commands.REGISTRATION.label}
      </Order>
    </div>
  );
}

function whatIsSaid(preview: TargetPreview): string {
  return preview.is_reachable
    ? `Reachable; ${preview.tightest ?? "no axis"} has the least room.`
    : refusalOf({
        detail: preview.message,
        ...(preview.axis !== null && { axis: preview.axis }),
        ...(preview.limit !== null && { limit: preview.limit }),
      });
}

/** Preview of the target; asked for once nothing has been typed for a moment. */
function usePreview(page: Page, text: string, cause: string): string | null {
  const [said, setSaid] = useState<string | null>(null);
  useEffect(() => {
    const aim = readAim(text);
    let isWanted = true;
    setSaid(null);
    if (aim === null) {
      return undefined;
    }
    const ask = async () => {
      const response = await page.request(
        "POST",
        PREVIEW_PATH,
        JSON.stringify(aim),
      );
      const answer = (await response.json()) as TargetPreview | Problem;
      if (isWanted) {
        setSaid(
          "detail" in answer
            ? refusalOf(answer)
            : whatIsSaid(fitted(answer, TargetPreview, PREVIEW_PATH)),
        );
      }
    };
    let timer: ReturnType<typeof setTimeout>;
    const askIn = (ms: number) => {
      timer = setTimeout(
        () => void ask().catch(() => isWanted && askIn(RETRY_MS)),
        ms,
      );
    };
    askIn(PREVIEW_AFTER_MS);
    return () => {
      isWanted = false;
      clearTimeout(timer);
    };
  }, [page, text, cause]);
  return said;
}

function PointOrder({
  name,
  outlook,
  commanding,
  text,
  setText,
}: AimProperties & {
  name: "Entry" | "Target";
  text: string;
  setText: (text: string) => void;
}) {
  const id = useId();
  const isEntry = name === "Entry";
  const point = readNumbers(text, 3);
  const aim = isEntry ? point && { point_mm: point } : readAim(text);
  const missing = `Write x, y and z in mm${isEntry ? "" : "; for a pose w=, x=, y= and z= behind them, or 16 numbers by rows"}.`;
  const kind = isEntry ? "ENTRY" : "TARGET";
  return (
    <div className="orders">
      <label htmlFor={id}>{name} point, scanner</label>
      <textarea
        id={id}
        rows={isEntry ? 1 : 4}
        cols={32}
        placeholder="x y z"
        value={text}
        onChange={(event) => setText(event.target.value)}
      />
      <Order
        commanding={commanding}
        path={commands[kind].path}
        fields={aim ?? {}}
        refusal={
          reasonAgainst(outlook, kind) ?? (aim === null ? missing : null)
        }
      >
        {commands[kind].label}
      </Order>
    </div>
  );
}

/**
 * With its rotation, which is what a point does not show; it is accepted whole.
 *
 * @satisfies SWR-CON-107
 */
function ProposedRegistration({ robot, outlook, commanding }: AimProperties) {
  const { registration: matrix, registration_by: by } =
    robot.targeting.proposals;
  return matrix === null ? null : (
    <>
      <Matrix
        label={`Proposed registration${formatOrigin(by)}`}
        matrix={matrix}
      />
      <div className="orders">
        <Order
          commanding={commanding}
          path={commands.REGISTRATION.path}
          fields={{ matrix }}
          refusal={reasonAgainst(outlook, "REGISTRATION")}
        >
          Accept registration
        </Order>
        <Order
          commanding={commanding}
          path={commands.WITHDRAW.path}
          fields={{ what: "proposed_registration" }}
        >
          {commands.WITHDRAW.label} registration
        </Order>
      </div>
    </>
  );
}

/** The proposal of a navigation program, to be accepted as it is shown. */
function ProposedEntry({ robot, outlook, commanding }: AimProperties) {
  const { entry_mm: point, entry_by: by } = robot.targeting.proposals;
  if (point === null) {
    return null;
  }
  return (
    <div className="orders">
      <span>
        Proposed entry {formatPoint(point)}
        {formatOrigin(by)}
      </span>
      <Order
        commanding={commanding}
        path={commands.ENTRY.path}
        fields={{ point_mm: point }}
        refusal={reasonAgainst(outlook, "ENTRY")}
      >
        Accept
      </Order>
      <Order
        commanding={commanding}
        path={commands.WITHDRAW.path}
        fields={{ what: "proposed_entry" }}
      >
        {commands.WITHDRAW.label}
      </Order>
    </div>
  );
}

/** Each length in a field of its own, sent by its name. */
function Probe({ robot, outlook, commanding }: AimProperties) {
  const { probe } = robot.targeting;
  const [texts, setTexts] = useState(
    probe.map(({ length_mm: length }) =>
      length === null ? "" : formatNumber(length, 3),
    ),
  );
  const id = useId();
  const lengths = probe.map(({ name }, i) => ({
    name,
    length_mm: readNumbers(texts[i] ?? "", 1)?.[0] ?? null,
  }));
  const missing = lengths.find((length) => length.length_mm === null);
  if (probe.length === 0) {
    return null;
  }
  return (
    <div className="orders">
      {probe.map(({ name, minimum_mm: least, maximum_mm: most }, i) => (
        <label key={name} htmlFor={id + name}>
          Probe {name}, {formatNumber(least, 0)} to {formatNumber(most, 0)} mm{" "}
          <input
            id={id + name}
            size={8}
            value={texts[i]}
            onChange={(event) => setTexts(texts.with(i, event.target.value))}
          />
        </label>
      ))}
      <Order
        commanding={commanding}
        path={commands.PROBE.path}
        fields={{ lengths }}
        refusal={
          reasonAgainst(outlook, "PROBE") ??
          (missing === undefined ? null : `Write a number for ${missing.name}.`)
        }
      >
        {commands.PROBE.label}
      </Order>
    </div>
  );
}

/**
 * Registration, probe, entry point and target, typed in or as they were proposed. Nothing moves by them.
 *
 * @satisfies SWR-CON-018
 * @satisfies SWR-CON-108
 */
export function Aim({
  robot,
  outlook,
  operation,
}: {
  robot: RobotState;
  outlook: Modes | null;
  operation: Operation;
}) {
  const commanding = useCommanding(operation, robot.status.authority);
  const [entry, setEntry] = useState("");
  const [target, setTarget] = useState("");
  const { is_registered, has_target } = robot.status;
  const { membranes } = robot.targeting;
  const cause = [is_registered, has_target, robot.targeting.entry_mm].join();
  const preview = usePreview(operation.page, target, cause);
  const properties = { robot, outlook, commanding };
  return (
    <>
      <OrderNotes commanding={commanding} />
      <ProposedRegistration {...properties} />
      <Registration {...properties} />
      <Probe
        key={robot.targeting.probe.map((one) => one.length_mm).join()}
        {...properties}
      />
      <ProposedEntry {...properties} />
      <PointOrder
        {...properties}
        name="Entry"
        text={entry}
        setText={setEntry}
      />
      <PointOrder
        {...properties}
        name="Target"
        text={target}
        setText={setTarget}
      />
      {preview !== null && <p role="status">{preview}</p>}
      {membranes !== null && (
        <MembraneOrder
          key={membranes.expected.map((one) => one.depth_mm).join()}
          membranes={membranes}
          outlook={outlook}
          commanding={commanding}
        />
      )}
      {robot.targeting.steering_most_per_km > 0 && (
        <SteeringOrder
          key={`${robot.targeting.steering_method.name} ${robot.targeting.steering_curvature_per_km} ${robot.targeting.steering_direction_deg}`}
          targeting={robot.targeting}
          outlook={outlook}
          commanding={commanding}
        />
      )}
    </>
  );
}
