// SPDX-License-Identifier: Apache-2.0
import type { Path } from "@interface";
import type { Commanding } from "../state/operation";
import { AskTwice } from "./AskTwice";

export interface TwiceProperties {
  question: string;
  commanding: Commanding;
  path: Path;
  fields?: object;
  /** Why not now; it is said by the group that this is one of. */
  refusal?: string | null;
  /** It was accepted. */
  onDone?: () => void;
  children: string;
}

/** An act that changes a position without a motion asks twice. */
export function Twice({
  question,
  commanding,
  path,
  fields,
  refusal = null,
  onDone,
  children,
}: TwiceProperties) {
  const command = async () => {
    if (await commanding.command(path, fields)) {
      onDone?.();
    }
  };
  return (
    <AskTwice
      question={question}
      isBarred={commanding.obstacle !== null || refusal !== null}
      why={refusal ?? undefined}
      onSure={() => void command()}
    >
      {children}
    </AskTwice>
  );
}
