// SPDX-License-Identifier: Apache-2.0
import { useEffect } from "react";
import { signOf } from "./sign";
import type { ConsoleView } from "../state/store";

/** A robot of another build may be unreadable; the page says so, its title need not. */
function titleOf(view: ConsoleView): string {
  try {
    return `${signOf(view).word} – Boresight`;
  } catch {
    return "Boresight";
  }
}

/** The tab says what the banner says. */
export function useTitle(view: ConsoleView): void {
  const title = titleOf(view);
  useEffect(() => {
    document.title = title;
  }, [title]);
}
