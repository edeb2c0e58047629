// SPDX-License-Identifier: Apache-2.0
import { commands, type Mode } from "@interface";
import { words } from "../words/format";
import { useCommanding, useKept } from "../state/operation";
import { reasonAgainst, usePoses } from "../state/outlook";
import { ButtonOrder, isButtonMode, Poses } from "../panels/modes/Needle";
import { ForcePlots } from "../panels/motors/ForcePlots";
import { ModeList } from "../panels/modes/ModeList";
import type { ModePanelProperties } from "../panels/modes/mode_panel";
import { Program } from "../panels/modes/Program";
import { Sweep } from "../panels/modes/Sweep";
import { Trajectory } from "../panels/modes/Trajectory";
import { Velocity } from "../panels/modes/Velocity";
import { Order, OrderNotes } from "../parts/Order";
import { Panel } from "../parts/Panel";
import { Progress } from "../parts/drawn/Progress";
import type { ViewProperties } from "./view";
import "./ModesView.css";

const own = {
  VELOCITY: Velocity,
  TRAJECTORY: Trajectory,
  SWEEP: Sweep,
  PROGRAM: Program,
} as const;

type Properties = ModePanelProperties & { name: string };

function PosesHere({ robot, operation, commanding, outlook }: Properties) {
  const poses = usePoses(operation.page, robot.status.boot_id);
  return <Poses commanding={commanding} outlook={outlook} poses={poses} />;
}

/** Armed by entering its workphase. */
function ByWorkphase({ name, commanding, outlook }: Properties) {
  const workphase = outlook?.modes.find((mode) => mode.name === name)
    ?.workphases[0];
  return workphase === undefined ? null : (
    <Order
      commanding={commanding}
      path={commands.WORKPHASE.path}
      fields={{ workphase }}
      refusal={reasonAgainst(outlook, name)}
    >
      {words(workphase)}
    </Order>
  );
}

/** By what the mode is commanded. */
function Orders(properties: Properties) {
  const { name, robot, commanding, outlook } = properties;
  if (name in own) {
    const Content = own[name as keyof typeof own];
    return <Content {...properties} />;
  }
  if (isButtonMode(name)) {
    return (
      <ButtonOrder
        mode={name}
        status={robot.status}
        commanding={commanding}
        outlook={outlook}
      />
    );
  }
  switch (name) {
    case "POSE":
      return <PosesHere {...properties} />;
    case "JOG":
    case "HOME_AXIS":
      return (
        <p>
          <a href="#motors">It is commanded axis by axis, in Motors.</a>
        </p>
      );
    default:
      return <ByWorkphase {...properties} />;
  }
}

function Facts({ mode }: { mode: Mode | undefined }) {
  return mode === undefined ? null : (
    <p className="mode-facts">
      {mode.says} In {mode.workphases.map(words).join(", ")}.{" "}
      {mode.command === "WORKPHASE"
        ? "Entering the workphase arms it; it moves while the pedal is pressed."
        : "Its command arms it; it moves while the pedal is pressed."}
    </p>
  );
}

/** One motion after the other: what it needs, its command, and how far it has come. */
export function ModesView({
  robot,
  operation,
  outlook,
  trace,
}: ViewProperties) {
  const { status } = robot;
  const [chosen, setChosen] = useKept<string | null>(operation, "mode", null);
  const commanding = useCommanding(operation, status.authority);
  const armed = status.mode.name === "NONE" ? "HOMING" : status.mode.name;
  const name = chosen ?? armed;
  const properties = { robot, operation, commanding, outlook, name };
  return (
    <>
      <Panel title="Modes">
        <ModeList
          outlook={outlook}
          status={status}
          chosen={name}
          choose={setChosen}
        />
      </Panel>
      <Panel key={name} title={words(name)}>
        <Facts mode={outlook?.modes.find((mode) => mode.name === name)} />
        <OrderNotes commanding={commanding} />
        <Orders {...properties} />
        <Progress status={status} />
      </Panel>
      {status.forces.length > 0 && (
        <Panel title="Force and depth" className="panel-wide">
          <ForcePlots needle={status.needle} trace={trace} />
        </Panel>
      )}
    </>
  );
}
