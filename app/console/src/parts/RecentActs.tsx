// SPDX-License-Identifier: Apache-2.0
import { useSyncExternalStore } from "react";
import type { Outcome } from "../state/acts";
import type { Level } from "../state/lamps";
import { mayCommand, type Operation } from "../state/operation";
import { nameOf } from "./Order";
import { Shape } from "./drawn/Shape";
import "./RecentActs.css";

const levels: Readonly<Record<Outcome["state"], Level>> = {
  sent: "unknown",
  accepted: "active",
  done: "normal",
  failed: "fault",
  lost: "unknown",
};

const states: Readonly<Record<Outcome["state"], string>> = {
  sent: "sent",
  accepted: "accepted",
  done: "done",
  failed: "not done",
  lost: "its end is not known",
};

function Reported({ outcome }: { outcome: Outcome }) {
  const { state, reason } = outcome;
  return (
    <>
      <Shape level={levels[state]} /> {nameOf(outcome)}: {states[state]}
      {reason !== null && `. ${reason}`}
    </>
  );
}

/**
 * The last commands of this page and their results, also when their panel was left before.
 *
 * @satisfies SWR-CON-046
 */
export function RecentActs({ operation }: { operation: Operation }) {
  const { session } = operation;
  const { recentActs } = operation.page;
  const view = useSyncExternalStore(session.subscribe, session.getView);
  const outcomes = useSyncExternalStore(
    recentActs.subscribe,
    recentActs.getOutcomes,
  );
  const [last, ...others] = outcomes;
  if (!mayCommand(view.session)) {
    return null;
  }
  if (last === undefined) {
    return <p className="recent-acts">No command from this page yet.</p>;
  }
  return (
    <details className="recent-acts">
      <summary>
        <span className="hidden">Last commands of this page. </span>
        <Reported outcome={last} />
      </summary>
      <ol aria-label="Commands before it">
        {others.map((outcome) => (
          <li key={outcome.id}>
            <Reported outcome={outcome} />
          </li>
        ))}
      </ol>
    </details>
  );
}
