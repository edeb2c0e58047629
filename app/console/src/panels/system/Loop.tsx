// SPDX-License-Identifier: Apache-2.0
import type { Status } from "@interface";

function rightsText({ fifo, core, memory }: Status["loop"]["rights"]): string {
  const missing = [
    fifo ? "" : "real-time scheduling",
    core ? "" : "a core of its own",
    memory ? "" : "locked memory",
  ].filter((right) => right !== "");
  return missing.length === 0 ? "all granted" : `without ${missing.join(", ")}`;
}

/**
 * @satisfies SWR-SUP-005
 * @satisfies SWR-BOX-044
 */
function timeText({
  is_elastic,
  speedup,
  speed_percent,
}: Status["time"]): string {
  const kind = speedup > 1 ? "fast" : is_elastic ? "elastic" : "real";
  return `${kind}, ${speed_percent.toFixed(1)} % speed`;
}

/**
 * The lacks of the computer for a punctual loop, with their remedies.
 *
 * @satisfies SWR-CON-036
 */
function Computer({ lacks }: { lacks: Status["loop"]["computer"] }) {
  return lacks.length === 0 ? (
    <>fit for real time</>
  ) : (
    <ul className="reasons">
      {lacks.map(({ name, text }) => (
        <li key={name}>{text}</li>
      ))}
    </ul>
  );
}

/** Elastic time waits for control, so these would all be zero. */
function Punctuality({ loop }: { loop: Status["loop"] }) {
  return (
    <>
      <dt>Worst wake-up, last second</dt>
      <dd>{loop.second_worst_us} µs</dd>
      <dt>Wake-up, 99 % / worst</dt>
      <dd>
        {loop.wake_p99_us} / {loop.wake_worst_us} µs
      </dd>
      <dt>Step, 99 % / worst</dt>
      <dd>
        {loop.step_p99_us} / {loop.step_worst_us} µs
      </dd>
    </>
  );
}

export function Loop({ status }: { status: Status }) {
  const { time, loop, counts } = status;
  return (
    <dl className="facts">
      <dt>Time</dt>
      <dd>{timeText(time)}</dd>
      {!time.is_elastic && <Punctuality loop={loop} />}
      <dt>Late cycles</dt>
      <dd>
        {counts.overruns} of {loop.cycles}
      </dd>
      <dt>Real-time rights</dt>
      <dd>{rightsText(loop.rights)}</dd>
      <dt>Computer</dt>
      <dd>
        <Computer lacks={loop.computer} />
      </dd>
      <dt>Page faults, all / from the disk</dt>
      <dd>
        {loop.minor_faults + loop.major_faults} / {loop.major_faults}
      </dd>
      <dt>Cycles not recorded</dt>
      <dd>{counts.cycles_lost}</dd>
    </dl>
  );
}
