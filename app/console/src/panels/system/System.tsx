// SPDX-License-Identifier: Apache-2.0
import type { Robot, Status } from "@interface";
import { formatCycles, formatUtc } from "../../words/format";

function runs(isRunning: boolean): string {
  return isRunning ? "running" : "not running";
}

/**
 * The running program, and the time since its start.
 *
 * @satisfies SWR-CON-036
 * @satisfies SWR-PACK-011
 * @satisfies SWR-NI-019
 */
export function System({
  status,
  robot,
}: {
  status: Status;
  robot: Robot | null;
}) {
  const { counts, processes } = status;
  return (
    <dl className="facts">
      <dt>Time, UTC</dt>
      <dd>{formatUtc(status.utc)}</dd>
      <dt>Since control started</dt>
      <dd>{formatCycles(status.cycle)}</dd>
      <dt>Version and build</dt>
      <dd>
        {status.version}, {status.build_id}
      </dd>
      <dt>Robot</dt>
      <dd>{status.robot}</dd>
      <dt>Checksum of its file</dt>
      <dd>{robot?.checksum ?? "not known yet"}</dd>
      <dt>Protocol of the cards</dt>
      <dd>{status.card_protocol}</dd>
      {status.cards_accepted !== null && (
        <>
          <dt>Cards accepted by</dt>
          <dd>{status.cards_accepted || "nobody, nothing moves"}</dd>
        </>
      )}
      <dt>Control box</dt>
      <dd>{status.box === null ? "real" : `simulated, ${status.box}`}</dd>
      <dt>Start of the server</dt>
      <dd>{status.boot_id}</dd>
      <dt>OpenIGTLink</dt>
      <dd>{runs(processes.igtl)}</dd>
      <dt>Recorder</dt>
      <dd>{runs(processes.recorder)}</dd>
      <dt>Events / lost</dt>
      <dd>
        {counts.events} / {counts.events_lost}
      </dd>
    </dl>
  );
}
