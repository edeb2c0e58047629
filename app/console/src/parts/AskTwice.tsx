// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";

/** A button that asks once more before it does anything. */
export function AskTwice({
  question,
  isBarred,
  why,
  label,
  onSure,
  children,
}: {
  question: string;
  isBarred: boolean;
  /** Why it is barred. */
  why?: string | undefined;
  /** Its name, where its text stands there more than once. */
  label?: string;
  onSure: () => void;
  children: string;
}) {
  const [isAsked, setIsAsked] = useState(false);
  if (!isAsked) {
    return (
      <span className="order">
        <button
          type="button"
          disabled={isBarred}
          title={why}
          aria-label={label}
          onClick={() => setIsAsked(true)}
        >
          {children}…
        </button>
      </span>
    );
  }
  const answer = () => {
    setIsAsked(false);
    onSure();
  };
  return (
    <span className="order order-asked" role="group" aria-label={question}>
      {question}{" "}
      <button type="button" onClick={answer}>
        {children}
      </button>{" "}
      <button type="button" autoFocus onClick={() => setIsAsked(false)}>
        Cancel
      </button>
    </span>
  );
}
