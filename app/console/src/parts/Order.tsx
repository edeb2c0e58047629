// SPDX-License-Identifier: Apache-2.0
import { useId, type ReactNode } from "react";
import "./Order.css";
import type { Path } from "@interface";
import type { Outcome } from "../state/acts";
import { labelOf } from "../words/commands";
import { words } from "../words/format";
import type { Commanding } from "../state/operation";

export interface OrderProperties {
  commanding: Commanding;
  path: Path;
  fields?: object;
  /** Why not now, as the server says it. */
  refusal?: string | null;
  /** It is said by the group that this is one of. */
  isTold?: boolean;
  isCurrent?: boolean;
  children: ReactNode;
}

const states: Readonly<Record<Outcome["state"], string>> = {
  sent: "sent",
  accepted: "accepted; its end is reported here",
  done: "done",
  failed: "not done",
  lost: "accepted; the connection was lost, so its end is not known",
};

/** State of the last act, if it is this one. */
function stateOf(
  outcome: Outcome | null,
  path: Path,
  fields: object = {},
): Outcome["state"] | undefined {
  const isThis =
    outcome?.path === path &&
    JSON.stringify(outcome.fields) === JSON.stringify(fields);
  return isThis ? outcome.state : undefined;
}

/** The label of the command, with the words that were chosen; a unit is none. */
export function nameOf({ path, fields }: Outcome): string {
  const what = Object.entries(fields)
    .filter(([field]) => field !== "unit")
    .map(([, value]: [string, unknown]) => value)
    .filter((value) => typeof value === "string");
  return [labelOf(path), ...what.map(words)].join(" ");
}

/** A button that commands, and beneath it why it cannot. A reason against all of them is shown once, by their panel. */
export function Order({
  commanding,
  path,
  fields,
  refusal = null,
  isTold = false,
  isCurrent = false,
  children,
}: OrderProperties) {
  const id = useId();
  return (
    <span className="order">
      <button
        type="button"
        disabled={commanding.obstacle !== null || refusal !== null}
        aria-describedby={refusal === null || isTold ? undefined : id}
        aria-current={isCurrent ? "step" : undefined}
        data-act={stateOf(commanding.outcome, path, fields)}
        onClick={() => void commanding.command(path, fields)}
      >
        {children}
      </button>
      {refusal !== null && !isTold && (
        <span className="order-refusal" id={id}>
          {refusal}
        </span>
      )}
    </span>
  );
}

/** Orders that belong together, and once why none of them is given now. */
export function Orders({
  name,
  refusal = null,
  children,
}: {
  name: string;
  refusal?: string | null;
  children: ReactNode;
}) {
  return (
    <div className="orders" role="group" aria-label={name}>
      {children}
      {refusal !== null && <p className="orders-refusal">{refusal}</p>}
    </div>
  );
}

/** The reason against all orders of a panel, and the result of the last one that came from it. */
export function OrderNotes({ commanding }: { commanding: Commanding }) {
  const { obstacle, own, problem } = commanding;
  return (
    <>
      {obstacle !== null && <p className="order-obstacle">{obstacle}</p>}
      <p className="order-outcome" role="status">
        {own !== null && `Last command: ${nameOf(own)}: ${states[own.state]}.`}
      </p>
      {problem !== null && (
        <p className="order-problem" role="alert">
          {problem}
        </p>
      )}
    </>
  );
}
