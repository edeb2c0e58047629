// SPDX-License-Identifier: Apache-2.0
import type { Authority, RobotState } from "@interface";
import { words } from "../format";
import { ageText } from "../lamps";
import { Shape } from "../parts/Shape";
import type { ConsoleView } from "../store";

function absence(view: ConsoleView): string {
  return view.refusal ?? "The server cannot be reached.";
}

function StaleBanner({ view }: { view: ConsoleView }) {
  const reason = view.isConnected
    ? `Control has sent nothing new for ${ageText(view.ageMs)}.`
    : absence(view);
  return (
    <div className="banner banner-stale" role="alert">
      <Shape level="fault" />
      <div>
        <p className="banner-next">DATA STALE</p>
        <p className="banner-state">
          {reason} What is shown is old. To stop the robot, release the pedal.
        </p>
      </div>
    </div>
  );
}

/** Whom to ask. */
function whoCommands({ state, name, age_s }: Authority): string {
  if (name !== null) {
    return `Commanded by ${name} for ${Math.floor(age_s)} s`;
  }
  return state === "ending"
    ? "Nobody commands before the axes rest"
    : "Nobody commands";
}

/** What a press of the button would mean. */
function meaningOf(robot: RobotState): string {
  const { request, request_axis } = robot.status.authority;
  switch (request) {
    case "TAKE":
      return "to command: release the pedal and press the button at the box";
    case "CONFIRM_AXIS":
      return `to confirm the position shown of ${robot.motors.axes[request_axis]?.name}: hold the button at the box`;
    default:
      return "to confirm the positions shown: hold the button at the box";
  }
}

/**
 * @satisfies SWR-CON-012
 * @satisfies SWR-CON-013
 */
function CommandRow({ robot }: { robot: RobotState }) {
  const { authority } = robot.status;
  return (
    <p className="banner-command">
      {whoCommands(authority)}
      {authority.left_s > 0 && (
        <strong className="banner-asked">
          {authority.requester_name} asks {meaningOf(robot)},{" "}
          {Math.ceil(authority.left_s)} s left
        </strong>
      )}
    </p>
  );
}

function StateBanner({ robot }: { robot: RobotState }) {
  const { status } = robot;
  return (
    <div className="banner" role="status">
      <div>
        <p className="banner-next">{status.next_step.text}</p>
        <p className="banner-state">
          <strong>{words(status.workphase.name)}</strong>{" "}
          {status.workphase.text}
        </p>
        <CommandRow robot={robot} />
      </div>
    </div>
  );
}

/**
 * What is needed next, and the state, in words.
 *
 * @satisfies SWR-CON-001
 * @satisfies SWR-CON-004
 * @satisfies SWR-CON-011
 */
export function Banner({ view }: { view: ConsoleView }) {
  if (view.robot === null) {
    return (
      <div className="banner" role="status">
        <div>
          <p className="banner-next">
            {view.isConnected ? "Waiting for control" : "No data"}
          </p>
          <p className="banner-state">
            {view.isConnected ? "The server has no data yet." : absence(view)}
          </p>
        </div>
      </div>
    );
  }
  return view.freshness === "stale" ? (
    <StaleBanner view={view} />
  ) : (
    <StateBanner robot={view.robot} />
  );
}
