// SPDX-License-Identifier: Apache-2.0
import { useState, useSyncExternalStore } from "react";
import { LogLevel, type EventSeverity, type Path } from "@interface";
import { change, useAnswer } from "../../state/answer";
import type { Operation } from "../../state/operation";
import { SeverityOptions } from "./LogSearch";

const LEVEL_PATH: Path = "/api/v1/log/level";
const ASK_AGAIN_MS = 5000;

/**
 * Which events the log's file gets.
 *
 * @satisfies SWR-CON-038
 */
export function LogFileLevel({ operation }: { operation: Operation }) {
  const { page } = operation;
  const { session } = useSyncExternalStore(
    operation.session.subscribe,
    operation.session.getView,
  );
  const [reported, takeAnswer] = useAnswer(
    page,
    LEVEL_PATH,
    LogLevel,
    ASK_AGAIN_MS,
    session?.role ?? "",
  );
  const [problem, setProblem] = useState<string | null>(null);
  if (reported === null) {
    return <p>Not known yet.</p>;
  }
  const set = async (level: EventSeverity) => {
    const changed = await change(page, "PUT", LEVEL_PATH, LogLevel, { level });
    setProblem("problem" in changed ? changed.problem : null);
    if ("answer" in changed) {
      takeAnswer(changed.answer);
    }
  };
  return (
    <div className="orders">
      <label>
        The file gets events from level{" "}
        <select
          value={reported.level}
          disabled={reported.reason !== null}
          onChange={(event) => void set(event.target.value as EventSeverity)}
        >
          <SeverityOptions />
        </select>
      </label>
      <p className="orders-refusal">
        {reported.by === null ? "As at the start." : `Set by ${reported.by}.`}{" "}
        {reported.reason}
      </p>
      {problem !== null && (
        <p className="order-problem" role="alert">
          {problem}
        </p>
      )}
    </div>
  );
}
