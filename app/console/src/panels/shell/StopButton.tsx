// SPDX-License-Identifier: Apache-2.0
import { useCallback, useEffect, useRef, useState } from "react";
import { Shape } from "../../parts/drawn/Shape";
import { isSeenStopped, requestStop } from "../../state/stop";
import type { ConsoleView } from "../../state/store";

type View = Pick<ConsoleView, "freshness" | "robot"> | null;

type Outcome =
  | { kind: "none" }
  | { kind: "asking" }
  | { kind: "confirmed" }
  | { kind: "failed"; reason: string };

/** The last press counts; a stop that control has confirmed counts whichever press it was for. */
function useStop(isSeen: boolean | null) {
  const [outcome, setOutcome] = useState<Outcome>({ kind: "none" });
  const presses = useRef(0);
  const stop = useCallback(() => {
    presses.current += 1;
    const press = presses.current;
    setOutcome((before) =>
      before.kind === "failed" ? before : { kind: "asking" },
    );
    void requestStop().then(({ isConfirmed, reason }) => {
      if (isConfirmed) {
        setOutcome({ kind: "confirmed" });
      } else if (press === presses.current) {
        setOutcome({ kind: "failed", reason });
      }
    });
  }, []);
  const hasFailed = outcome.kind === "failed";
  useEffect(() => {
    if (hasFailed && isSeen) {
      setOutcome({ kind: "none" });
    }
  }, [hasFailed, isSeen]);
  return { outcome, stop };
}

/** A key that is held repeats itself; only its press counts. */
function useEscape(stop: () => void): void {
  useEffect(() => {
    const listen = (event: KeyboardEvent) => {
      if (event.key === "Escape" && !event.repeat) {
        stop();
      }
    };
    window.addEventListener("keydown", listen, { capture: true });
    return () =>
      window.removeEventListener("keydown", listen, { capture: true });
  }, [stop]);
}

function sentence(outcome: Outcome, isSeen: boolean | null): string {
  if (outcome.kind === "asking") {
    return "Asking control to stop…";
  }
  if (isSeen === true) {
    return "Control has stopped all motion.";
  }
  return outcome.kind === "confirmed" && isSeen === null
    ? "Control has confirmed the stop. Whether it still stands is not known."
    : "A software stop. The e-stop is on the robot.";
}

function Failure({ reason }: { reason: string }) {
  return (
    <div className="stop-failed" role="alert">
      <Shape level="fault" />
      <p>
        <strong>NOT STOPPED</strong> {reason} Release the pedal, or pull the
        e-stop.
      </p>
    </div>
  );
}

/**
 * Asks for no confirmation. Works with stale data too: the request may get through where the stream does not. Its
 * words about control come from the data of this moment (`view`, null: there is none).
 *
 * @satisfies SWR-CON-007
 * @satisfies SWR-CON-008
 * @satisfies SWR-CON-010
 */
export function StopButton({ view }: { view: View }) {
  const isSeen = view && isSeenStopped(view.freshness, view.robot);
  const { outcome, stop } = useStop(isSeen);
  useEscape(stop);
  return (
    <>
      <div className="stop">
        <button
          type="button"
          className="stop-button"
          onClick={stop}
          onKeyDown={(event) => event.repeat && event.preventDefault()}
        >
          <svg viewBox="0 0 20 20" aria-hidden="true">
            <path d="M1 1h18v18H1z" />
          </svg>
          STOP MOTION
          <kbd>Esc</kbd>
        </button>
        <p className="stop-result" role="status">
          {sentence(outcome, isSeen)}
        </p>
      </div>
      {outcome.kind === "failed" && <Failure reason={outcome.reason} />}
    </>
  );
}
