// SPDX-License-Identifier: Apache-2.0
import type { Status } from "@interface";
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

function StateBanner({ status }: { status: Status }) {
  return (
    <div className="banner" role="status">
      <div>
        <p className="banner-next">{status.next_step.text}</p>
        <p className="banner-state">
          <strong>{words(status.workphase.name)}</strong>{" "}
          {status.workphase.text}
        </p>
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
    <StateBanner status={view.robot.status} />
  );
}
