// SPDX-License-Identifier: Apache-2.0
import { useState, useSyncExternalStore } from "react";
import { Axes } from "./panels/Axes";
import { Banner } from "./panels/Banner";
import { Command } from "./panels/Command";
import { Lamps } from "./panels/Lamps";
import { Log } from "./panels/Log";
import { Login } from "./panels/Login";
import { Loop } from "./panels/Loop";
import { Ports } from "./panels/Ports";
import { StopButton } from "./panels/StopButton";
import { Targeting } from "./panels/Targeting";
import { Boundary } from "./parts/Boundary";
import { Panel } from "./parts/Panel";
import { ThemeButton } from "./parts/ThemeButton";
import { SessionStore } from "./session";
import type { RobotState, Time } from "@interface";
import type { ConsoleView, TelemetryStore } from "./store";

const SLOW_PERCENT = 95;

function Panels({ view, robot }: { view: ConsoleView; robot: RobotState }) {
  return (
    <div className="panels" data-freshness={view.freshness}>
      <Panel title="Lamps" className="panel-lamps">
        <Lamps view={view} robot={robot} />
      </Panel>
      <Panel title="Axes" className="panel-axes">
        <Axes axes={robot.motors.axes} />
      </Panel>
      <Panel title="Targeting" className="panel-targeting">
        <Targeting targeting={robot.targeting} />
      </Panel>
      <Panel title="Control loop" className="panel-loop">
        <Loop status={robot.status} />
      </Panel>
      <Panel title="OpenIGTLink" className="panel-ports">
        <Ports ports={robot.status.ports} />
      </Panel>
      <Panel title="Log" className="panel-log">
        <Log log={view.log} />
      </Panel>
    </div>
  );
}

function Footer({ robot }: { robot: RobotState | null }) {
  return (
    <footer>
      <span>Boresight console</span>
      {robot !== null && (
        <>
          <span>Robot {robot.status.robot}</span>
          <span>Build {robot.status.build_id}</span>
        </>
      )}
      <ThemeButton />
    </footer>
  );
}

/** A slow simulation must not be taken for a slow robot. */
function SlowTime({ time }: { time: Time }) {
  const percent = Math.round(time.speed_percent);
  return percent < SLOW_PERCENT ? (
    <p className="notice">Time passes at {percent} % of its speed.</p>
  ) : null;
}

function Notices({ view }: { view: ConsoleView }) {
  const box = view.robot?.status.box ?? null;
  return (
    <>
      {box !== null && (
        <p className="notice">
          Simulated control box “{box}”: no robot is connected.
        </p>
      )}
      {view.robot !== null && <SlowTime time={view.robot.status.time} />}
      {view.isOutdated && (
        <p className="notice">The server has been updated. Reload this page.</p>
      )}
    </>
  );
}

/** Who is logged in, and whether this page commands. */
function Operator({ view }: { view: ConsoleView }) {
  const [session] = useState(() => new SessionStore());
  return (
    <div className="operator">
      <Login store={session} />
      {view.robot !== null && (
        <Command session={session} authority={view.robot.status.authority} />
      )}
    </div>
  );
}

/** What is left when all else has failed. */
export function Emergency() {
  return (
    <header>
      <p className="panel-failed">
        The console cannot be shown. Reload the page; the robot is not affected.
      </p>
      <StopButton view={null} />
    </header>
  );
}

/**
 * The whole page. Whatever fails in it is cut out; the stop stays.
 *
 * @satisfies SWR-CON-009
 */
export function App({ store }: { store: TelemetryStore }) {
  const view = useSyncExternalStore(store.subscribe, store.getView);
  return (
    <>
      <header>
        <h1 className="hidden">Boresight console</h1>
        <Boundary name="banner">
          <Banner view={view} />
        </Boundary>
        <Boundary name="stop" instead={<StopButton view={null} />}>
          <StopButton view={view} />
        </Boundary>
      </header>
      <main>
        <Boundary name="login">
          <Operator view={view} />
        </Boundary>
        <Boundary name="page">
          <Notices view={view} />
          {view.robot !== null && <Panels view={view} robot={view.robot} />}
        </Boundary>
      </main>
      <Boundary name="footer">
        <Footer robot={view.robot} />
      </Boundary>
    </>
  );
}
