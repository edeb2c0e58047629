// SPDX-License-Identifier: Apache-2.0
import type { Status } from "@interface";
import "./Progress.css";

/** The whole that the share is of; for the other modes it is their present leg. */
const shares: Readonly<Partial<Record<Status["mode"]["name"], string>>> = {
  HOMING: "of the axes",
  TRAJECTORY: "of its time",
  VELOCITY: "of its time or way",
  PROGRAM: "of its present step",
  SWEEP: "of its present step",
};

/**
 * How far what moves has come, and how long it lasts yet where that is known. Empty while nothing moves, in the same room.
 *
 * @satisfies SWR-CON-047
 */
export function Progress({ status }: { status: Status }) {
  if (status.order !== "moving") {
    return <p className="progress" />;
  }
  const percent = Math.floor(status.done_per_mille / 10);
  const left =
    status.left_ms > 0 ? `, ${Math.ceil(status.left_ms / 1000)} s left` : "";
  return (
    <p className="progress">
      <progress max={100} value={percent} aria-label={status.mode.text} />
      <span>
        {percent} % {shares[status.mode.name] ?? "of its present leg"}
        {left}
      </span>
    </p>
  );
}
