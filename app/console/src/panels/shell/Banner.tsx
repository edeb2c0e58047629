// SPDX-License-Identifier: Apache-2.0
import type { ReactNode } from "react";
import type { Alarm, Authority, RobotState, Status } from "@interface";
import { needleText, sinceText } from "../../state/alarms";
import { words } from "../../words/format";
import { ageText } from "../../state/lamps";
import { SignShape } from "../../parts/drawn/SignShape";
import { signOf, type Sign } from "../../words/sign";
import type { ConsoleView } from "../../state/store";
import "./Banner.css";

function absence(view: ConsoleView): string {
  return view.refusal ?? "The server cannot be reached.";
}

/** Screen readers announce the sign and the text beside it whenever it changes; `more` they find. */
function Frame({
  sign,
  more,
  children,
}: {
  sign: Sign;
  more?: ReactNode;
  children: ReactNode;
}) {
  return (
    <div className="banner" data-sign={sign.kind}>
      <div
        className="banner-text"
        role={sign.kind === "stale" ? "alert" : "status"}
      >
        <p className="sign">
          <SignShape kind={sign.kind} />
          <strong className="sign-word">{sign.word}</strong>
        </p>
        <div className="banner-text">{children}</div>
      </div>
      {more}
    </div>
  );
}

function StaleBanner({ view, sign }: { view: ConsoleView; sign: Sign }) {
  const reason = view.isConnected
    ? `Control has sent nothing new for ${ageText(view.ageMs)}.`
    : absence(view);
  return (
    <Frame sign={sign}>
      <p className="banner-next">To stop the robot, release the pedal.</p>
      <p className="banner-state">{reason} The values shown are old.</p>
    </Frame>
  );
}

/** The client to ask for authority. */
function whoCommands({ state, name, age_s }: Authority): string {
  if (name !== null) {
    return `Commanded by ${name} for ${Math.floor(age_s)} s`;
  }
  if (state === "held") {
    return "Commanded by somebody whose name is not known here";
  }
  return state === "ending"
    ? "Nobody commands before the axes rest"
    : "Nobody commands";
}

/** Meaning of a press of the button. */
function meaningOf(robot: RobotState): string {
  const { request, request_axis } = robot.status.authority;
  switch (request) {
    case "TAKE":
      return "to command: release the pedal and press the button at the box";
    case "CONFIRM_AXIS":
      return `to confirm the position shown of ${robot.motors.axes[request_axis]?.name ?? "an axis"}: hold the button at the box`;
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
    <div className="banner-command">
      {whoCommands(authority)}
      {authority.left_s > 0 && (
        <strong className="banner-asked">
          <span role="status">
            {authority.requester_name} asks {meaningOf(robot)}
          </span>
          , {Math.ceil(authority.left_s)} s left
        </strong>
      )}
    </div>
  );
}

/**
 * Unrecorded cycles are in no file, and only this banner shows that in time.
 *
 * @satisfies SWR-SUP-012
 */
function Gap({ status }: { status: Status }) {
  const cycles = status.counts.unrecorded;
  return cycles === 0 ? null : (
    <p className="banner-state">
      <strong>Not recorded:</strong> the last {cycles} cycles, as the recorder{" "}
      {status.is_recorder_failing
        ? "cannot write them: free space on its disk, or make its folder one that can be written."
        : "does not read them."}
    </p>
  );
}

/** The axis and the card that the next step is about, and what is wrong there. */
function namedOf({ status, motors }: RobotState): string {
  const axis = motors.axes[status.step_axis]?.name;
  const card = status.cards.find(({ slot }) => slot === status.step_card);
  const names = [
    ...(axis === undefined ? [] : [axis]),
    ...(card === undefined ? [] : [`card ${card.slot}`]),
  ];
  return status.step_event === null
    ? ""
    : ` ${names.join(", ")}: ${words(status.step_event)}.`;
}

const stages: Record<Status["loop"]["late_stage"]["name"], string> = {
  WAKE: "Waking up",
  CARDS: "The exchange with the cards",
  STEP: "The controller's step",
  PUBLISH: "Publishing",
};

/**
 * The cause of the stop of a loop that was late too often.
 *
 * @satisfies SWR-CON-090
 */
function lateness({ loop }: Status): string {
  if (loop.state !== "stopped") {
    return "";
  }
  const late = `${(loop.late_us / 1000).toFixed(1)} ms`;
  const times = loop.late_count === 1 ? "once" : `${loop.late_count} times`;
  const span = `${Math.ceil(loop.late_span_us / 1000)} ms`;
  const isOrdinary = loop.computer.some(({ name }) => name === "KERNEL");
  const why = isOrdinary ? "; this kernel is not a real-time kernel" : "";
  return ` ${stages[loop.late_stage.name]} was late by ${late}, ${times} in ${span}${why}.`;
}

/** A user who is not logged in has no button. */
function nextOf(robot: RobotState, mayCommand: boolean): string {
  const { name, text } = robot.status.next_step;
  const isToLogIn = name === "AUTHORITY" && !mayCommand;
  return isToLogIn
    ? "Log in to take command here, or command from the navigation program."
    : text + namedOf(robot) + lateness(robot.status);
}

/** One of them is why nothing moves, and stands above. */
function Others({ alarms }: { alarms: readonly Alarm[] }) {
  return alarms.length === 0 ? null : (
    <ul className="banner-alarms" aria-label="Alarms">
      {alarms.map((alarm) => (
        <li key={alarm.text}>
          {alarm.text} {sinceText(alarm)}
        </li>
      ))}
    </ul>
  );
}

/** Its age grows: screen readers find it, and do not announce it each second. */
function Needle({ status }: { status: Status }) {
  const text = needleText(status);
  return text === null ? null : (
    <p className="banner-command banner-needle">
      <strong>{text}</strong>
    </p>
  );
}

function StateBanner({
  robot,
  sign,
  mayCommand,
}: {
  robot: RobotState;
  sign: Sign;
  mayCommand: boolean;
}) {
  const { status } = robot;
  const first = status.alarms.find(({ text }) => text === sign.says);
  return (
    <Frame
      sign={sign}
      more={
        <>
          <Needle status={status} />
          <CommandRow robot={robot} />
        </>
      }
    >
      <p className="banner-why">
        {sign.says}
        {first?.since != null && ` ${sinceText(first)}`}
      </p>
      <p className="banner-next">{nextOf(robot, mayCommand)}</p>
      <p className="banner-state">
        <strong>{words(status.workphase.name)}</strong> {status.workphase.text}
      </p>
      <Gap status={status} />
      <Others alarms={status.alarms.filter((alarm) => alarm !== first)} />
    </Frame>
  );
}

/**
 * Does it move, may it, why not; then what is needed next, and the state, in words.
 *
 * @satisfies SWR-SITE-022
 * @satisfies SWR-SITE-023
 * @satisfies SWR-SITE-024
 * @satisfies SWR-CON-001
 * @satisfies SWR-CON-004
 * @satisfies SWR-CON-011
 * @satisfies SWR-CON-049
 * @satisfies SWR-CON-050
 * @satisfies SWR-CON-096
 * @satisfies SWR-CON-099
 */
export function Banner({
  view,
  mayCommand = true,
}: {
  view: ConsoleView;
  mayCommand?: boolean;
}) {
  const sign = signOf(view);
  if (view.robot === null) {
    return (
      <Frame sign={sign}>
        <p className="banner-next">
          {view.isConnected ? "Waiting for control" : absence(view)}
        </p>
        <p className="banner-state">
          {view.isConnected
            ? "The server has no data yet."
            : "Whether the robot moves is not known here."}
        </p>
      </Frame>
    );
  }
  return view.freshness === "stale" ? (
    <StaleBanner view={view} sign={sign} />
  ) : (
    <StateBanner robot={view.robot} sign={sign} mayCommand={mayCommand} />
  );
}
