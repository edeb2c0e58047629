// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";
import type { Path } from "@interface";
import type { Commanding } from "../operation";

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

/** What changes a position without a motion is asked twice. */
export function Twice({
  question,
  commanding,
  path,
  fields,
  refusal = null,
  onDone,
  children,
}: TwiceProperties) {
  const [isAsked, setIsAsked] = useState(false);
  const command = async () => {
    setIsAsked(false);
    if (await commanding.command(path, fields)) {
      onDone?.();
    }
  };
  if (!isAsked) {
    return (
      <span className="order">
        <button
          type="button"
          disabled={commanding.obstacle !== null || refusal !== null}
          title={refusal ?? undefined}
          onClick={() => setIsAsked(true)}
        >
          {children}…
        </button>
      </span>
    );
  }
  return (
    <span className="order order-asked" role="group" aria-label={question}>
      {question}{" "}
      <button type="button" onClick={() => void command()}>
        {children}
      </button>{" "}
      <button type="button" autoFocus onClick={() => setIsAsked(false)}>
        Cancel
      </button>
    </span>
  );
}
