// SPDX-License-Identifier: Apache-2.0
// The user of this page, and its means to command.
import {
  createContext,
  useContext,
  useState,
  useSyncExternalStore,
} from "react";
import type { Authority, Path, Session } from "@interface";
import type { Outcome } from "./acts";
import { PageAuthority } from "./authority";
import { Losses } from "./losses";
import { Page } from "./page";
import { SessionStore } from "./session";

/** The data is stale: what is shown of the robot is not known any more. */
export const Stale = createContext(false);

export class Operation {
  readonly session = new SessionStore();
  readonly page = new Page(() => this.session.getView().session?.token ?? null);
  readonly authority = new PageAuthority(this.page);
  readonly losses = new Losses(this);
  /** Inputs in views that are not shown now. */
  readonly kept = new Map<string, unknown>();
}

/** As a state, but it outlives its panel. `name`: of what is kept; one type for each. */
export function useKept<Value>(
  operation: Operation,
  name: string,
  initial: Value,
): [Value, (value: Value) => void] {
  const { kept } = operation;
  const [value, setValue] = useState(() =>
    kept.has(name) ? (kept.get(name) as Value) : initial,
  );
  const keep = (next: Value) => {
    kept.set(name, next);
    setValue(next);
  };
  return [value, keep];
}

export function mayCommand(session: Session | null): boolean {
  return session !== null && session.is_open && session.role !== "OBSERVER";
}

/** Why this page commands nothing now, or null. */
export function obstacleOf(
  session: Session | null,
  isMine: boolean,
): string | null {
  if (!mayCommand(session)) {
    return "Log in as operator to command.";
  }
  return isMine ? null : "Take command first.";
}

export interface Commanding {
  /** Why nothing can be commanded from here, or null. */
  obstacle: string | null;
  /** It may do what engineers may. */
  isEngineer: boolean;
  /** Result of the last command of this page, from any panel. */
  outcome: Outcome | null;
  /** The same, if it came from this panel. */
  own: Outcome | null;
  /** Why that failed, or null. */
  problem: string | null;
  command(path: Path, fields?: object): Promise<boolean>;
}

/**
 * For a panel that commands.
 *
 * @satisfies SWR-CON-061
 */
export function useCommanding(
  operation: Operation,
  authority: Authority,
): Commanding {
  const [own, setOwn] = useState<number | null>(null);
  const { session, page } = operation;
  const { recentActs } = page;
  const outcome = useSyncExternalStore(
    recentActs.subscribe,
    recentActs.getOutcome,
  );
  const view = useSyncExternalStore(session.subscribe, session.getView);
  const role = view.session?.role ?? null;
  const command = async (path: Path, fields: object = {}) => {
    const refusal = page.act(path, fields);
    setOwn(recentActs.getOutcome()?.id ?? null);
    return (await refusal) === null;
  };
  const isStale = useContext(Stale);
  const isMine = operation.authority.isMine(authority);
  const mine = outcome?.id === own ? outcome : null;
  return {
    obstacle: isStale
      ? "What the robot does is not known now."
      : obstacleOf(view.session, isMine),
    isEngineer: role === "ENGINEER" || role === "SERVICE",
    outcome,
    own: mine,
    problem: mine?.reason ?? null,
    command,
  };
}
