// SPDX-License-Identifier: Apache-2.0
import { useState, useSyncExternalStore } from "react";
import { Aim } from "./panels/Aim";
import { Axes } from "./panels/Axes";
import { Banner } from "./panels/Banner";
import { Command } from "./panels/Command";
import { Lamps } from "./panels/Lamps";
import { Log } from "./panels/Log";
import { Login } from "./panels/Login";
import { Loop } from "./panels/Loop";
import { Motion } from "./panels/Motion";
import { Ports } from "./panels/Ports";
import { Procedure } from "./panels/Procedure";
import { StopButton } from "./panels/StopButton";
import { Targeting } from "./panels/Targeting";
import { Boundary } from "./parts/Boundary";
import { Panel } from "./parts/Panel";
import { ThemeButton } from "./parts/ThemeButton";
import { Operation } from "./operation";
import { useOutlook } from "./outlook";
import type { RobotState, Time } from "@interface";
import type { ConsoleView, TelemetryStore } from "./store";

const SLOW_PERCENT = 95;

interface PanelsProperties {
  view: ConsoleView;
  robot: RobotState;
  operation: Operation;
}

function Panels({ view, robot, operation }: PanelsProperties) {
  const outlook = useOutlook(operation.page, robot.status);
  return (
    <div className="panels" data-freshness={view.freshness}>
      <Panel title="Lamps" className="panel-lamps">
        <Lamps view={view} robot={robot} />
      </Panel>
      <Panel title="Procedure" className="panel-procedure">
        <Procedure
          status={robot.status}
          outlook={outlook}
          operation={operation}
        />
      </Panel>
      <Panel title="Axes" className="panel-axes">
        <Axes axes={robot.motors.axes} />
      </Panel>
      <Panel title="Targeting">
        <Targeting targeting={robot.targeting} />
      </Panel>
      <Panel title="Aim">
        <Aim robot={robot} operation={operation} />
      </Panel>
      <Panel title="Control loop">
        <Loop status={robot.status} />
      </Panel>
      <Panel title="Motion">
        <Motion robot={robot} outlook={outlook} operation={operation} />
      </Panel>
      <Panel title="OpenIGTLink">
        <Ports ports={robot.status.ports} />
      </Panel>
      <Panel title="Log">
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
function Operator({
  view,
  operation,
}: {
  view: ConsoleView;
  operation: Operation;
}) {
  return (
    <div className="operator">
      <Login store={operation.session} />
      {view.robot !== null && (
        <Command
          operation={operation}
          authority={view.robot.status.authority}
        />
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
  const [operation] = useState(() => new Operation());
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
          <Operator view={view} operation={operation} />
        </Boundary>
        <Boundary name="page">
          <Notices view={view} />
          {view.robot !== null && (
            <Panels view={view} robot={view.robot} operation={operation} />
          )}
        </Boundary>
      </main>
      <Boundary name="footer">
        <Footer robot={view.robot} />
      </Boundary>
    </>
  );
}
