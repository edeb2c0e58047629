// SPDX-License-Identifier: Apache-2.0
import { useMemo, useState } from "react";
import { formatUtc, words } from "../words/format";
import { Axes } from "../panels/procedure/Axes";
import { Banner } from "../panels/shell/Banner";
import { SeenCharts } from "../panels/system/Charts";
import { DrawnRobot } from "../panels/procedure/Drawing";
import { Plots } from "../panels/motors/Plots";
import { Boundary } from "../parts/Boundary";
import { Panel } from "../parts/Panel";
import { ThemeChoice } from "../parts/ThemeChoice";
import { signOf } from "../words/sign";
import { Events } from "./Events";
import { Frames } from "./Frames";
import {
  viewOf,
  type Identity,
  type Moment,
  type Recording,
} from "./recording";
import { Timeline } from "./Timeline";

const SECOND = 1000;

function proofText({ difference, is_trusted, ...one }: Identity): string {
  if (difference !== "") {
    return `NOT EXACT. ${difference} Nothing after it is shown.`;
  }
  if (!is_trusted) {
    return "NOT TRUSTED. The recording does not hold what it announces.";
  }
  if (one.replayed === 0) {
    return "Nothing was replayed: no cycle follows a checkpoint.";
  }
  const least = one.has_run_end ? "" : "at least ";
  const share = `${one.replayed} of ${least}${one.cycles} cycles replayed`;
  return one.is_whole_run
    ? `Bit-exact: ${share}, every output equal.`
    : `Bit-exact as far as it goes: ${share}, their outputs equal; this is not the whole run.`;
}

function gapsText(one: Identity): string {
  const gaps = [
    one.first > 0 && `cycles 0 to ${one.first - 1} of the run`,
    one.missing > 0 && `${one.missing} cycles in between`,
    !one.has_run_end && "the end of the run",
    one.is_cut_short && "the recording is cut short",
    one.cycles_lost > 0 && `${one.cycles_lost} cycles before it were lost`,
    one.unreplayed > 0 &&
      `${one.unreplayed} cycles follow no checkpoint and were not replayed`,
  ].filter((gap) => gap !== false);
  return gaps.length === 0 ? "nothing" : gaps.join("; ");
}

/** @satisfies SWR-REPLAY-017 */
function Facts({ identity }: { identity: Identity }) {
  return (
    <dl className="facts">
      <dt>Replay</dt>
      <dd>{proofText(identity)}</dd>
      <dt>Missing</dt>
      <dd>{gapsText(identity)}</dd>
      <dt>Run, cycles</dt>
      <dd>
        {identity.run}, {identity.first} to {identity.cycles - 1}
      </dd>
      <dt>Robot, checksum</dt>
      <dd>
        {identity.robot}, {identity.checksum}
      </dd>
      <dt>Recorded by build</dt>
      <dd>{identity.build}</dd>
      <dt>Replayed by build</dt>
      <dd>{identity.replayed_by}</dd>
      <dt>Begins (UTC)</dt>
      <dd>{formatUtc(identity.started)}</dd>
    </dl>
  );
}

function saysOf(cycle: number, moment: Moment | null): string {
  if (moment === null) {
    return `cycle ${cycle}, not known`;
  }
  const { timeS, robot } = moment;
  const { kind, word, says } = signOf(viewOf(robot));
  const why = kind === "moving" || says === "" ? "" : `: ${says}`;
  return `cycle ${cycle}, ${timeS.toFixed(2)} s, ${words(robot.status.workphase.name)}, ${word}${why}`;
}

interface StepsProperties {
  recording: Recording;
  cycle: number;
  onCycle: (cycle: number) => void;
}

function Steps({ recording, cycle, onCycle }: StepsProperties) {
  const { events, first, last } = recording;
  const before = events.findLast((event) => event.cycle < cycle);
  const after = events.find((event) => event.cycle > cycle);
  const steps: [string, number | undefined][] = [
    ["Previous event", before?.cycle],
    ["Back 1 s", cycle - SECOND],
    ["Back 1 cycle", cycle - 1],
    ["On 1 cycle", cycle + 1],
    ["On 1 s", cycle + SECOND],
    ["Next event", after?.cycle],
  ];
  return steps.map(([label, to]) => (
    <button
      key={label}
      type="button"
      disabled={to === undefined}
      onClick={() =>
        to !== undefined && onCycle(Math.min(last, Math.max(first, to)))
      }
    >
      {label}
    </button>
  ));
}

function Panels({
  moment,
  recording,
}: {
  moment: Moment;
  recording: Recording;
}) {
  const { robot, trace, frames, seen, since } = moment;
  const began =
    since === recording.first ? "the recording began" : `cycle ${since}`;
  return (
    <>
      <Panel title="Axes" className="panel-wide">
        <Axes axes={robot.motors.axes} />
      </Panel>
      <Panel title="The robot" className="panel-wide">
        <DrawnRobot robot={robot} described={recording.robot} />
      </Panel>
      <Panel title="The 30 s until this cycle" className="panel-wide">
        <Plots axes={robot.motors.axes} trace={trace} />
      </Panel>
      <Panel title="Frames to each card" className="panel-wide">
        <Frames frames={frames} robot={recording.robot} />
      </Panel>
      <Panel title="Charts" className="panel-wide">
        <SeenCharts
          robot={robot}
          seen={seen}
          source={{ since: began, clock: "the recording" }}
        />
      </Panel>
    </>
  );
}

/**
 * A recording, to be looked at cycle by cycle with the parts of the console. A cycle in a gap is not shown.
 *
 * @satisfies SWR-REPLAY-018
 * @satisfies SWR-REPLAY-021
 */
export function Replay({ recording }: { recording: Recording }) {
  const [cycle, setCycle] = useState(recording.first);
  const moment = useMemo(() => recording.at(cycle), [recording, cycle]);
  const steps = { recording, cycle, onCycle: setCycle };
  const says = saysOf(cycle, moment);
  return (
    <>
      <header>
        <h1 className="hidden">Boresight recording</h1>
        {moment === null ? (
          <p className="panel-failed">
            Not known: the recording has nothing of this cycle, or nothing that
            follows a checkpoint.
          </p>
        ) : (
          <Boundary name="banner">
            <Banner view={viewOf(moment.robot)} />
          </Boundary>
        )}
      </header>
      <main>
        <p className="notice">
          A recording, not the robot: nothing here moves anything. States, words
          and what a card is asked to drive are those of the cycle; numbers are
          reported each {recording.numbersEach} cycles and with each event.
        </p>
        <div className="panels">
          <Panel title="Timeline" className="panel-wide">
            <Timeline {...steps} says={says} />
            <div className="replay-steps">
              <strong className="replay-now" role="status">
                {says}
              </strong>
              <Steps {...steps} />
            </div>
          </Panel>
          <Panel title="Recording">
            <Facts identity={recording.identity} />
          </Panel>
          <Panel title="Events">
            <Events events={recording.events} {...steps} />
          </Panel>
          {moment !== null && <Panels moment={moment} recording={recording} />}
        </div>
      </main>
      <footer>
        <span>Boresight recording</span>
        <ThemeChoice />
      </footer>
    </>
  );
}
