// SPDX-License-Identifier: Apache-2.0
import { commands } from "@interface";
import { words } from "../words/format";
import type { HeldList, Verdict } from "../state/lists";
import type { Commanding } from "../state/operation";
import { refusalOf } from "../state/refusal";
import { Order } from "./Order";

/** Where it is wrong, as people say it: /steps/2 is the third step. */
function placeOf(pointer: string): string {
  const step = /^\/steps\/(\d+)/.exec(pointer)?.[1];
  return step === undefined ? pointer : `step ${Number(step) + 1}`;
}

/** Control's verdict on the list that was sent: by name, with the place. `quote`: the text there. */
export function Check({
  verdict,
  quote = null,
}: {
  verdict: Verdict | null;
  quote?: string | null;
}) {
  if (verdict?.state !== "refused") {
    return (
      <p className="order-outcome" role="status">
        {verdict?.state === "checking" && "Sent; every row is checked…"}
        {verdict?.state === "held" && "Checked, and held."}
      </p>
    );
  }
  const { problem } = verdict;
  return (
    <p className="order-problem" role="alert">
      <strong>Refused: {problem.code ?? "NO_ANSWER"}</strong>
      {problem.pointer !== undefined && `, ${placeOf(problem.pointer)}`}
      {". "}
      {refusalOf(problem)}
      {quote !== null && (
        <>
          {" "}
          <code>{quote}</code>
        </>
      )}
    </p>
  );
}

interface Held {
  checksum: number;
  source: string | null;
}

/** Sends a list, runs the one that is held, and empties it. */
export function ListOrders<Answer extends Held>({
  commanding,
  list,
  run,
  refusal,
  missing,
  send,
}: {
  commanding: Commanding;
  list: HeldList<Answer>;
  run: "RUN_TRAJECTORY" | "RUN_PROGRAM";
  /** Why it cannot be run now. */
  refusal: string | null;
  /** The input that is missing before it can be sent, or null. */
  missing: string | null;
  send(): void;
}) {
  const isBarred = commanding.obstacle !== null;
  const isChecking = list.verdict?.state === "checking";
  const isHeld = list.held !== null && list.held.source !== null;
  return (
    <div className="orders">
      <span className="order">
        <button
          type="button"
          disabled={isBarred || isChecking || missing !== null}
          onClick={send}
        >
          Send and check
        </button>
        {missing !== null && <span className="order-refusal">{missing}</span>}
      </span>
      <Order
        commanding={commanding}
        path={commands[run].path}
        fields={{ checksum: list.held?.checksum }}
        refusal={refusal}
      >
        {commands[run].label}
      </Order>
      <span className="order">
        <button
          type="button"
          disabled={isBarred || isChecking || !isHeld}
          onClick={list.empty}
        >
          Delete what is held
        </button>
      </span>
    </div>
  );
}

/** Which one is held: from whom, and its checksum. */
export function HeldName({ held }: { held: Held }) {
  const checksum = held.checksum.toString(16).padStart(8, "0");
  return (
    <>
      from {words(held.source ?? "nobody")}, checksum {checksum}
    </>
  );
}
