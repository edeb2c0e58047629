// SPDX-License-Identifier: Apache-2.0
import {
  lazy,
  Suspense,
  useEffect,
  useState,
  useSyncExternalStore,
} from "react";
import { Banner } from "./panels/shell/Banner";
import { Command } from "./panels/shell/Command";
import { SystemLamps } from "./panels/shell/Lamps";
import { Login } from "./panels/shell/Login";
import { StopButton } from "./panels/shell/StopButton";
import { Boundary } from "./parts/Boundary";
import { Clock } from "./parts/drawn/Clock";
import { Losses } from "./parts/Losses";
import { RecentActs } from "./parts/RecentActs";
import { ThemeChoice } from "./parts/ThemeChoice";
import { mayCommand, Operation, Stale } from "./state/operation";
import { useOutlook } from "./state/outlook";
import type { RobotState } from "@interface";
import { Help } from "./help/Help";
import type { ConsoleView, TelemetryStore } from "./state/store";
import type { Trace } from "./words/trace";
import { useTitle } from "./words/title";
import { useChosenView, views, type ViewEntry } from "./views/views";

/** A page with a real robot does not need it. */
const Box = lazy(async () => ({
  default: (await import("./panels/box/Box")).Box,
}));

function Navigation({ chosen }: { chosen: ViewEntry }) {
  return (
    <nav className="views" aria-label="Views">
      {views.map(({ id, title }) => (
        <a
          key={id}
          href={`#${id}`}
          aria-current={id === chosen.id ? "page" : undefined}
        >
          {title}
        </a>
      ))}
    </nav>
  );
}

interface ViewsProperties {
  view: ConsoleView;
  robot: RobotState;
  operation: Operation;
  trace: Trace;
}

function Views({ view, robot, operation, trace }: ViewsProperties) {
  const outlook = useOutlook(operation.page, robot.status);
  const chosen = useChosenView();
  const properties = { view, robot, operation, outlook, trace };
  return (
    <>
      <SystemLamps view={view} status={robot.status} />
      <Navigation chosen={chosen} />
      <div className="panels" data-freshness={view.freshness}>
        <Boundary key={chosen.id} name={chosen.title}>
          <Suspense fallback={<p>Loading {chosen.title}…</p>}>
            <chosen.Content {...properties} />
          </Suspense>
        </Boundary>
      </div>
    </>
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
      <Clock />
      <ThemeChoice />
    </footer>
  );
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
      {view.isOutdated && (
        <p className="notice">
          The server has been updated. Reload this page.
          {view.misfit !== undefined && ` (${view.misfit})`}
        </p>
      )}
    </>
  );
}

/** The user who is logged in, the authority of this page, and help. */
function Toolbar({
  view,
  operation,
}: {
  view: ConsoleView;
  operation: Operation;
}) {
  return (
    <div className="toolbar">
      <Login store={operation.session} />
      {view.robot !== null && (
        <>
          <Command
            operation={operation}
            authority={view.robot.status.authority}
            speedup={view.robot.status.time.speedup}
          />
          <Losses
            operation={operation}
            status={view.robot.status}
            log={view.log}
          />
        </>
      )}
      <Boundary name="notice">
        <Notices view={view} />
      </Boundary>
      <Help />
      <RecentActs operation={operation} />
    </div>
  );
}

function SimulatedBox({
  view,
  operation,
}: {
  view: ConsoleView;
  operation: Operation;
}) {
  const name = view.robot?.status.box ?? null;
  return name === null ? null : (
    <Suspense fallback={null}>
      <Box name={name} operation={operation} freshness={view.freshness} />
    </Suspense>
  );
}

/** The page that is left when all else has failed. */
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
 * The whole page. A part that fails is cut out; the stop stays.
 *
 * @satisfies SWR-CON-009
 * @satisfies SWR-CON-022
 */
export function App({ store }: { store: TelemetryStore }) {
  const view = useSyncExternalStore(store.subscribe, store.getView);
  const [operation] = useState(() => new Operation());
  useEffect(
    () => store.tellActsTo(operation.page.recentActs),
    [store, operation],
  );
  const { session } = useSyncExternalStore(
    operation.session.subscribe,
    operation.session.getView,
  );
  useTitle(view);
  return (
    <>
      <header>
        <h1 className="hidden">Boresight console</h1>
        <Boundary name="banner">
          <Banner view={view} mayCommand={mayCommand(session)} />
        </Boundary>
        <Boundary name="stop" instead={<StopButton view={null} />}>
          <StopButton view={view} />
        </Boundary>
      </header>
      <main>
        <Stale value={view.freshness === "stale"}>
          <Boundary name="toolbar">
            <Toolbar view={view} operation={operation} />
          </Boundary>
          <Boundary name="page">
            {view.robot !== null && (
              <Views
                view={view}
                robot={view.robot}
                operation={operation}
                trace={store.trace}
              />
            )}
          </Boundary>
        </Stale>
      </main>
      <Boundary name="simulated box">
        <SimulatedBox view={view} operation={operation} />
      </Boundary>
      <Boundary name="footer">
        <Footer robot={view.robot} />
      </Boundary>
    </>
  );
}
