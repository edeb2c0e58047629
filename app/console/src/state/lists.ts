// SPDX-License-Identifier: Apache-2.0
// Lists that control judges row by row, holds, and runs by their checksum.
import { useState } from "react";
import type { Path, Problem, Shape } from "@interface";
import { useAnswer } from "./answer";
import { useKept, type Operation } from "./operation";
import { ASK_AGAIN_MS } from "./outlook";
import type { RequestOptions } from "./page";

/** Control judges one row in a cycle: the longest list takes 5 s, in slow motion more. */
const CHECK_TIMEOUT_MS = 60_000;

/** Control's verdict on the list that was sent last. */
export type Verdict =
  | { state: "checking" }
  | { state: "held"; checksum: number }
  | { state: "refused"; problem: Partial<Problem> };

export interface HeldList<Answer> {
  /** As the server shows it; null while it is not known. */
  held: Answer | null;
  /** It is that which this page has sent, and so its rows are known here. */
  isOurs: boolean;
  verdict: Verdict | null;
  send(body: string, type?: string): void;
  empty(): void;
  /** The verdict is about another list than the one that is shown now. */
  forget(): void;
}

export function useList<Answer extends { checksum: number }>(
  operation: Operation,
  path: Path,
  shape: Shape<Answer>,
): HeldList<Answer> {
  const { page } = operation;
  const [turn, setTurn] = useState(0);
  const [held] = useAnswer(page, path, shape, ASK_AGAIN_MS, String(turn));
  const [verdict, setVerdict] = useKept<Verdict | null>(operation, path, null);
  const exchange = async (
    method: "POST" | "DELETE",
    options: RequestOptions,
  ) => {
    setVerdict(method === "POST" ? { state: "checking" } : null);
    const { answer, problem } = await page.exchange<Answer>(method, path, {
      ...options,
      timeoutMs: CHECK_TIMEOUT_MS,
    });
    if (problem !== null) {
      setVerdict({ state: "refused", problem });
    } else if (answer !== null && method === "POST") {
      setVerdict({ state: "held", checksum: answer.checksum });
    }
    setTurn((last) => last + 1);
  };
  return {
    held,
    isOurs: verdict?.state === "held" && verdict.checksum === held?.checksum,
    verdict,
    send: (body, type = "application/json") =>
      void exchange("POST", { body, type }),
    empty: () => void exchange("DELETE", {}),
    forget: () => setVerdict(null),
  };
}
