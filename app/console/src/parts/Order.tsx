// SPDX-License-Identifier: Apache-2.0
import { useId, type ReactNode } from "react";
import type { Path } from "@interface";
import type { Commanding } from "../operation";

export interface OrderProperties {
  commanding: Commanding;
  path: Path;
  fields?: object;
  /** Why not now, as the server says it. */
  refusal?: string | null;
  /** It is said by the group that this is one of. */
  isTold?: boolean;
  isCurrent?: boolean;
  children: ReactNode;
}

/** A button that commands, and beneath it why it cannot. What bars all of them is said once, by their panel. */
export function Order({
  commanding,
  path,
  fields,
  refusal = null,
  isTold = false,
  isCurrent = false,
  children,
}: OrderProperties) {
  const id = useId();
  return (
    <span className="order">
      <button
        type="button"
        disabled={commanding.obstacle !== null || refusal !== null}
        aria-describedby={refusal === null || isTold ? undefined : id}
        aria-current={isCurrent ? "step" : undefined}
        onClick={() => void commanding.command(path, fields)}
      >
        {children}
      </button>
      {refusal !== null && !isTold && (
        <span className="order-refusal" id={id}>
          {refusal}
        </span>
      )}
    </span>
  );
}

/** Orders that belong together, and once why none of them is given now. */
export function Orders({
  name,
  refusal = null,
  children,
}: {
  name: string;
  refusal?: string | null;
  children: ReactNode;
}) {
  return (
    <div className="orders" role="group" aria-label={name}>
      {children}
      {refusal !== null && <p className="orders-refusal">{refusal}</p>}
    </div>
  );
}

/** What bars all orders of a panel, and what became of the last one. */
export function OrderNotes({ commanding }: { commanding: Commanding }) {
  return (
    <>
      {commanding.obstacle !== null && (
        <p className="order-obstacle">{commanding.obstacle}</p>
      )}
      {commanding.problem !== null && (
        <p className="order-problem" role="alert">
          {commanding.problem}
        </p>
      )}
    </>
  );
}
