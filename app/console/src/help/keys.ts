// SPDX-License-Identifier: Apache-2.0
// Keys that lead somewhere: ? to the help, g and a letter to a view. They can be switched off, and are while one types.
import { useEffect, useState } from "react";
import { keep, recall } from "../state/keep";
import { views, type ViewEntry } from "../views/views";

const KEY = "keys";
const PREFIX = "g";
const PREFIX_MS = 2000;

/** The first letter of its title that no view before it has. */
export function letterOf(view: ViewEntry): string {
  const taken: string[] = [];
  for (const { id, title } of views) {
    const letters = [...title.toLowerCase()];
    const letter = letters.find((one) => !taken.includes(one)) ?? "";
    if (id === view.id) {
      return letter;
    }
    taken.push(letter);
  }
  return "";
}

function isTyping({ target }: KeyboardEvent): boolean {
  return (
    target instanceof Element &&
    target.closest("input, textarea, select, [contenteditable]") !== null
  );
}

function goTo(letter: string): void {
  const view = views.find((one) => letterOf(one) === letter);
  if (view !== undefined) {
    window.location.hash = view.id;
  }
}

/** Listens while `isOn`. */
export function useKeys(isOn: boolean, openHelp: () => void): void {
  useEffect(() => {
    let prefixedAt = -Infinity;
    const listen = (event: KeyboardEvent) => {
      if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event)) {
        return;
      }
      if (event.key === "?") {
        openHelp();
      } else if (event.timeStamp - prefixedAt < PREFIX_MS) {
        goTo(event.key);
      }
      prefixedAt = event.key === PREFIX ? event.timeStamp : -Infinity;
    };
    if (isOn) {
      window.addEventListener("keydown", listen);
    }
    return () => window.removeEventListener("keydown", listen);
  }, [isOn, openHelp]);
}

/** Whether the keys are on, and how to switch them. */
export function useKeysChoice(): [boolean, (isOn: boolean) => void] {
  const [isOn, setIsOn] = useState(() => recall(KEY) !== "off");
  const choose = (choice: boolean) => {
    keep(KEY, choice ? "on" : "off");
    setIsOn(choice);
  };
  return [isOn, choose];
}
