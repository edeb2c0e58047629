// SPDX-License-Identifier: Apache-2.0
import { useSyncExternalStore } from "react";
import { addressOf } from "./address";
import { TimeTravel } from "./TimeTravel";
import { CYCLES_PER_MS } from "./pace";
import type { Question } from "./question";
import type { RobotTransport, RobotView } from "./robot_transport";
import { WhatIf } from "./WhatIf";
import "./Simulation.css";

const MS_PER_S = 1000;
/** The page that holds the pedal repeats it each 0.5 s of the world, and the box lets go after 1.5 s of its own: not above 2. */
const paces: readonly (readonly [number, string])[] = [
  [0, "Pause"],
  [0.1, "A tenth"],
  [1, "Real time"],
  [2, "Twice"],
];

interface Properties {
  robot: Pick<
    RobotTransport,
    | "subscribe"
    | "getView"
    | "setPace"
    | "step"
    | "goTo"
    | "shareCourse"
    | "compare"
  >;
  /** Names of all robots. */
  names: readonly string[];
  /** By the link of the page. */
  asked: Question | null;
  onAnew(): void;
}

function Names({
  identity,
  names,
}: Pick<RobotView, "identity"> & Pick<Properties, "names">) {
  return names.map((name) =>
    name === identity?.robot ? (
      <strong key={name}>{name}</strong>
    ) : (
      <a key={name} href={addressOf(name)}>
        {name}
      </a>
    ),
  );
}

/**
 * Time in the page.
 *
 * @satisfies SWR-SITE-014
 */
function Pace({
  robot,
  view,
}: Pick<Properties, "robot"> & { view: RobotView }) {
  const isPaused = view.share === 0;
  return (
    <div className="simulation-pace" role="group" aria-label="Time">
      {paces.map(([share, name]) => (
        <button
          key={name}
          type="button"
          aria-pressed={share === view.share}
          onClick={() => robot.setPace(share)}
        >
          {name}
        </button>
      ))}
      <button type="button" disabled={!isPaused} onClick={() => robot.step()}>
        One cycle
      </button>
    </div>
  );
}

/** Why there is no robot: what the link asks for cannot be shown, or it has failed. */
function Trouble({
  failure,
  isRefused,
  usual,
}: Pick<RobotView, "failure" | "isRefused"> & { usual: string }) {
  return isRefused ? (
    <p role="alert">
      The link of this page is refused. {failure}{" "}
      <a href={addressOf(usual)}>A robot without it</a>
    </p>
  ) : (
    <p role="alert">
      The robot of this page is gone. Start it anew. ({failure})
    </p>
  );
}

/**
 * Says all the time that no robot is here, and what it is that is shown.
 *
 * @satisfies SWR-SITE-013
 */
export function Simulation({ robot, names, asked, onAnew }: Properties) {
  const view = useSyncExternalStore(robot.subscribe, robot.getView);
  const { identity, cycles, failure } = view;
  const timeS = (cycles / CYCLES_PER_MS / MS_PER_S).toFixed(3);
  return (
    <section className="simulation" aria-label="Simulation">
      <p className="simulation-word" role="note">
        <strong>Simulation.</strong> No robot moves.
      </p>
      <div className="simulation-bar">
        {failure !== null && (
          <Trouble
            failure={failure}
            isRefused={view.isRefused}
            usual={identity?.robot ?? names[0] ?? ""}
          />
        )}
        <p className="simulation-names">
          Robot <Names identity={identity} names={names} />
        </p>
        {identity !== null && (
          <p>
            File {identity.checksum}, build {identity.build}
          </p>
        )}
        <Pace robot={robot} view={view} />
        <p className="simulation-time">
          {timeS} s, cycle {cycles}
        </p>
        <button type="button" onClick={onAnew}>
          Start anew
        </button>
        <a href="./replay.html">Open a recording</a>
      </div>
      <details className="simulation-more" open={asked !== null}>
        <summary>Back in time, share, what if</summary>
        <TimeTravel robot={robot} view={view} />
        <WhatIf robot={robot} view={view} asked={asked} />
      </details>
    </section>
  );
}
