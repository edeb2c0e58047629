// SPDX-License-Identifier: Apache-2.0
// The views of the console. The first is there at once, the others come when they are opened.
import { lazy, useSyncExternalStore, type ComponentType } from "react";
import { ProcedureView } from "./ProcedureView";
import type { ViewProperties } from "./view";

export interface ViewEntry {
  /** After the # of the address. */
  id: string;
  title: string;
  Content: ComponentType<ViewProperties>;
}

const procedure: ViewEntry = {
  id: "procedure",
  title: "Procedure",
  Content: ProcedureView,
};

/** @satisfies SWR-CON-024 */
export const views: readonly ViewEntry[] = [
  procedure,
  {
    id: "motors",
    title: "Motors",
    Content: lazy(async () => ({
      default: (await import("./MotorsView")).MotorsView,
    })),
  },
  {
    id: "modes",
    title: "Modes",
    Content: lazy(async () => ({
      default: (await import("./ModesView")).ModesView,
    })),
  },
  {
    id: "status",
    title: "Status",
    Content: lazy(async () => ({
      default: (await import("./StatusView")).StatusView,
    })),
  },
  {
    id: "charts",
    title: "Charts",
    Content: lazy(async () => ({
      default: (await import("./ChartsView")).ChartsView,
    })),
  },
  {
    id: "communication",
    title: "Communication",
    Content: lazy(async () => ({
      default: (await import("./CommunicationView")).CommunicationView,
    })),
  },
  {
    id: "log",
    title: "Log",
    Content: lazy(async () => ({
      default: (await import("./LogView")).LogView,
    })),
  },
];

function listen(changed: () => void): () => void {
  window.addEventListener("hashchange", changed);
  return () => window.removeEventListener("hashchange", changed);
}

/** The view that the page's address names; the first one if it names none. */
export function useChosenView(): ViewEntry {
  const id = useSyncExternalStore(listen, () => window.location.hash.slice(1));
  return views.find((entry) => entry.id === id) ?? procedure;
}
