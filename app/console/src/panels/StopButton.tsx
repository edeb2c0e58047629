// SPDX-License-Identifier: Apache-2.0
import { useCallback, useEffect, useState } from "react";
import { requestStop, type StopResult } from "../api";

/** Asks for no confirmation. Works with stale data too: the request may get through where the stream does not. */
export function StopButton() {
  const [result, setResult] = useState<StopResult | null>(null);
  const stop = useCallback(() => {
    setResult({ isStopped: false, message: "Asking control to stop…" });
    void requestStop().then(setResult);
  }, []);

  useEffect(() => {
    const listen = (event: KeyboardEvent) => {
      if (event.key === "Escape") {
        stop();
      }
    };
    window.addEventListener("keydown", listen);
    return () => window.removeEventListener("keydown", listen);
  }, [stop]);

  return (
    <div className="stop">
      <button type="button" className="stop-button" onClick={stop}>
        STOP MOTION
        <kbd>Esc</kbd>
      </button>
      <p className="stop-result" role="status">
        {result?.message ?? "A software stop. The e-stop is on the robot."}
      </p>
    </div>
  );
}
