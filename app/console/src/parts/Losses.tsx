// SPDX-License-Identifier: Apache-2.0
import { useEffect, useSyncExternalStore } from "react";
import type { Status } from "@interface";
import type { Operation } from "../state/operation";
import type { ConsoleView } from "../state/store";

/**
 * The losses of this page and their causes, until the user has read them.
 *
 * @satisfies SWR-CON-091
 * @satisfies SWR-SESS-035
 */
export function Losses({
  operation,
  status,
  log,
}: {
  operation: Operation;
  status: Status;
  log: ConsoleView["log"];
}) {
  const { losses, session: store } = operation;
  const { session } = useSyncExternalStore(store.subscribe, store.getView);
  const sentences = useSyncExternalStore(losses.subscribe, losses.getSentences);
  useEffect(
    () => losses.observe({ status, session, log }),
    [losses, status, session, log],
  );
  return (
    sentences.length > 0 && (
      <section className="login" aria-label="Lost" role="alert">
        <p className="login-problem">{sentences.join(" ")}</p>
        <button type="button" onClick={losses.dismiss}>
          Read
        </button>
      </section>
    )
  );
}
