// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState } from "react";
import { stops } from "./stops";
import "./help.css";

const MARK = "data-toured";

/** Outlines the element that is spoken of. The mark is an attribute that no other part writes. */
function useOutline(selector: string): void {
  useEffect(() => {
    const element = document.querySelector(selector);
    element?.setAttribute(MARK, "");
    element?.scrollIntoView({ block: "nearest" });
    return () => element?.removeAttribute(MARK);
  }, [selector]);
}

/**
 * One thing after the other, until all were seen or it is skipped.
 *
 * @satisfies SWR-CON-023
 */
export function Tour({ onClose }: { onClose: () => void }) {
  const [at, setAt] = useState(0);
  const stop = stops[Math.min(at, stops.length - 1)];
  const next = useRef<HTMLButtonElement>(null);
  useOutline(stop?.selector ?? "body");
  useEffect(() => next.current?.focus(), []);
  const isLast = at === stops.length - 1;
  return (
    <section className="tour" aria-label="First steps">
      <p aria-live="polite">
        <strong>
          {at + 1} of {stops.length}: {stop?.title}
        </strong>
        <br />
        {stop?.says}
      </p>
      <div className="tour-ways">
        <button
          type="button"
          disabled={at === 0}
          onClick={() => setAt((before) => before - 1)}
        >
          Back
        </button>
        <button
          type="button"
          ref={next}
          onClick={() => (isLast ? onClose() : setAt((before) => before + 1))}
        >
          {isLast ? "Done" : "Next"}
        </button>
        {!isLast && (
          <button type="button" onClick={onClose}>
            Skip the rest
          </button>
        )}
      </div>
    </section>
  );
}
