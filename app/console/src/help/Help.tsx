// SPDX-License-Identifier: Apache-2.0
import { lazy, Suspense, useCallback, useState } from "react";
import { Boundary } from "../parts/Boundary";
import { useKeys, useKeysChoice } from "./keys";

const Sheet = lazy(async () => ({
  default: (await import("./HelpSheet")).HelpSheet,
}));
const Tour = lazy(async () => ({ default: (await import("./Tour")).Tour }));

/**
 * The button for help, and what it opens: nothing of it covers STOP or takes the keyboard from it.
 *
 * @satisfies SWR-CON-023
 */
export function Help() {
  const [shown, setShown] = useState<"nothing" | "sheet" | "tour">("nothing");
  const [areKeysOn, setKeysOn] = useKeysChoice();
  const open = useCallback(() => setShown("sheet"), []);
  const close = useCallback(() => setShown("nothing"), []);
  useKeys(areKeysOn, open);
  return (
    <>
      <button type="button" className="help-button" onClick={open}>
        Help {areKeysOn && <kbd>?</kbd>}
      </button>
      <Boundary name="help">
        <Suspense>
          {shown === "sheet" && (
            <Sheet
              areKeysOn={areKeysOn}
              setKeysOn={setKeysOn}
              onClose={close}
              onTour={() => setShown("tour")}
            />
          )}
          {shown === "tour" && <Tour onClose={close} />}
        </Suspense>
      </Boundary>
    </>
  );
}
