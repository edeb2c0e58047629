// SPDX-License-Identifier: Apache-2.0
// The way back to an earlier cycle, and a link to it for others.
import { useState, type FormEvent } from "react";
import { linkOf } from "./address";
import { CYCLES_PER_MS } from "./pace";
import type { RobotTransport, RobotView } from "./robot_transport";

const SECOND = 1000 * CYCLES_PER_MS;
/** Before it there is no robot to be shown. */
const FIRST = 1;

interface Properties {
  robot: Pick<RobotTransport, "goTo" | "shareCourse">;
  view: RobotView;
}

/**
 * Where time goes back to.
 *
 * @satisfies SWR-SITE-032
 */
function Back({ robot, view: { cycles, end, later } }: Properties) {
  const [wanted, setWanted] = useState("");
  const steps: readonly (readonly [string, number])[] = [
    ["To the start", FIRST],
    ["Back 1 s", Math.max(FIRST, cycles - SECOND)],
    ["Back one cycle", cycles - 1],
  ];
  const go = (event: FormEvent) => {
    event.preventDefault();
    robot.goTo(Number(wanted));
  };
  return (
    <>
      <div className="simulation-pace" role="group" aria-label="Time back">
        {steps.map(([name, cycle]) => (
          <button
            key={name}
            type="button"
            disabled={cycles <= FIRST}
            onClick={() => robot.goTo(cycle)}
          >
            {name}
          </button>
        ))}
      </div>
      <form onSubmit={go}>
        <label>
          Cycle{" "}
          <input
            type="number"
            required
            min={FIRST}
            max={end}
            value={wanted}
            onChange={({ target }) => setWanted(target.value)}
          />
        </label>{" "}
        <button type="submit">Go to it</button>
      </form>
      <p role="status">
        {end > cycles &&
          `It has been to cycle ${end}. When time goes on from here, that is forgotten, with ${later} ${later === 1 ? "input" : "inputs"}.`}
      </p>
    </>
  );
}

/**
 * The inputs so far, as a link.
 *
 * @satisfies SWR-SITE-030
 */
function Share({ robot, view: { shared } }: Properties) {
  return (
    <>
      <button type="button" onClick={() => robot.shareCourse()}>
        Share
      </button>
      {shared?.kind === "unshared" && <p role="alert">{shared.reason}</p>}
      {shared?.kind === "shared" && (
        <label className="simulation-link">
          Link to the {shared.inputs} inputs before cycle {shared.cycle}{" "}
          <input
            readOnly
            value={linkOf(shared.scene)}
            onFocus={({ target }) => target.select()}
          />
        </label>
      )}
    </>
  );
}

export function TimeTravel(properties: Properties) {
  return (
    <div className="simulation-bar">
      <Back {...properties} />
      <Share {...properties} />
    </div>
  );
}
