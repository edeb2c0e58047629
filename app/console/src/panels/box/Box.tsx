// SPDX-License-Identifier: Apache-2.0
import {
  useEffect,
  useId,
  useState,
  useSyncExternalStore,
  type ReactNode,
} from "react";
import type { Box as BoxState, BoxOrderRequest } from "@interface";
import {
  BoxHands,
  type BoxView,
  type Handle,
  type Hold,
} from "../../state/box";
import type { Freshness } from "../../state/freshness";
import { mayCommand, obstacleOf, type Operation } from "../../state/operation";
import { HoldButton } from "../../parts/HoldButton";
import { BoxFaults } from "./BoxFaults";
import { BoxForce, Grip } from "./BoxForce";
import { BoxNeedle } from "./BoxNeedle";
import { hasForceSensor } from "./force";
import "./Box.css";

const gates: Record<BoxState["gate"], string> = {
  off: "says nothing",
  dose: "dose reached",
  stop: "says stop",
};
const PUSH_MM = 10;

interface WorkProperties {
  hands: BoxHands;
  view: BoxView;
  box: BoxState;
  isDisabled: boolean;
}

/** Its state and what changes it. */
function Group({
  name,
  state,
  children,
}: {
  name: string;
  state: string;
  children?: ReactNode;
}) {
  return (
    <div className="box-group" role="group" aria-label={name}>
      <p>
        <span className="box-name">{name}</span> <strong>{state}</strong>
      </p>
      {children}
    </div>
  );
}

const holds: Record<Hold, string> = {
  none: "held by another page",
  held: "held by this page",
  latched: "kept by this page",
};

function stateOf(isPressed: boolean, holder: number, hold: Hold): string {
  if (!isPressed) {
    return "released";
  }
  return holder === 0 ? "pressed at the box" : holds[hold];
}

const handleNames: Record<Handle, string> = {
  pedal: "Pedal",
  button: "Button",
  hand: "Handle",
};

function Held({
  hands,
  view,
  box,
  isDisabled,
  handle,
}: WorkProperties & { handle: Handle }) {
  const hold = view[handle];
  const isLatched = hold === "latched";
  const name = handleNames[handle].toLowerCase();
  return (
    <Group
      name={handleNames[handle]}
      state={stateOf(
        box[`is_${handle}_pressed`],
        box[`${handle}_holder`],
        hold,
      )}
    >
      <HoldButton
        label={`Hold ${name}`}
        isHeld={hold !== "none"}
        isDisabled={isDisabled}
        onHold={() => void hands.hold(handle, "held")}
        onDrop={() => void hands.drop(handle)}
      />
      <button
        type="button"
        role="switch"
        aria-checked={isLatched}
        disabled={isDisabled || hold === "held"}
        onClick={() =>
          void (isLatched ? hands.drop(handle) : hands.hold(handle, "latched"))
        }
      >
        Keep {name} pressed
      </button>
    </Group>
  );
}

/** Without a force sensor nothing at the box feels a hand at the handle. */
function Handles(properties: WorkProperties) {
  return (
    <>
      <Held {...properties} handle="pedal" />
      <Held {...properties} handle="button" />
      {hasForceSensor(properties.box) && (
        <>
          <Held {...properties} handle="hand" />
          <Grip {...properties} />
        </>
      )}
    </>
  );
}

function orderBy({ hands, isDisabled }: WorkProperties) {
  return (label: string, one: BoxOrderRequest) => (
    <button
      type="button"
      disabled={isDisabled}
      onClick={() => void hands.order(one)}
    >
      {label}
    </button>
  );
}

/** States with two values, and the buttons that change them. */
function Levels(properties: WorkProperties) {
  const { box } = properties;
  const order = orderBy(properties);
  return (
    <>
      <Group
        name="E-stop"
        state={box.is_estop_pulled ? "pulled" : "not pulled"}
      >
        {box.is_estop_pulled
          ? order("Reset e-stop", { estop: "reset" })
          : order("Pull e-stop", { estop: "pull" })}
      </Group>
      <Group
        name="Scanner"
        state={box.is_scanner_active ? "acquires" : "rests"}
      >
        {box.is_scanner_active
          ? order("Scanner off", { scanner: "off" })
          : order("Scanner on", { scanner: "on" })}
      </Group>
    </>
  );
}

/** Those that are lit, in words. */
function litOf(box: BoxState): string {
  const lit = [
    box.is_lamp_alive && "alive",
    box.is_lamp_may_move && "may move",
    box.is_lamp_moving && "moving",
    box.is_lamp_fault && "fault",
  ].filter((word) => word !== false);
  return lit.length === 0 ? "dark" : lit.join(", ");
}

/** The parts that few users need. */
function Treatment(properties: WorkProperties) {
  const { box } = properties;
  const isFree = box.probe === "free";
  const order = orderBy(properties);
  return (
    <>
      <Group name="Gate of a treatment" state={gates[box.gate]}>
        {box.gate !== "dose" && order("Reach dose", { gate: "dose" })}
        {box.gate !== "stop" && order("Say stop", { gate: "stop" })}
        {box.gate !== "off" && order("Say nothing", { gate: "off" })}
      </Group>
      <Group name="Probe" state={isFree ? "in the hand" : "on its axis"}>
        {isFree
          ? order("Couple probe", { probe: "coupled" })
          : order("Free probe", { probe: "free" })}
        {order(`Push ${PUSH_MM} mm in`, { push_mm: PUSH_MM })}
        {order(`Push ${PUSH_MM} mm out`, { push_mm: -PUSH_MM })}
      </Group>
    </>
  );
}

function Open({
  operation,
  freshness,
}: {
  operation: Operation;
  freshness: Freshness;
}) {
  const [hands] = useState(() => new BoxHands(operation.page));
  const view = useSyncExternalStore(hands.subscribe, hands.getView);
  const { session } = useSyncExternalStore(
    operation.session.subscribe,
    operation.session.getView,
  );
  const mayWork = mayCommand(session);
  useEffect(() => {
    hands.start();
    return () => hands.stop();
  }, [hands]);
  useEffect(() => {
    if (!mayWork || freshness === "stale") {
      hands.letGo();
    }
  }, [hands, mayWork, freshness]);
  const obstacle = obstacleOf(session, true);
  const { box, problem } = view;
  const isDisabled = obstacle !== null || freshness === "stale";
  const properties = { hands, view, isDisabled };
  return (
    <>
      {obstacle !== null && <p className="order-obstacle">{obstacle}</p>}
      {problem !== null && (
        <p className="order-problem" role="alert">
          {problem}
        </p>
      )}
      {box === null ? (
        <p>The simulated box has not answered.</p>
      ) : (
        <>
          <div className="box-groups">
            <Handles {...properties} box={box} />
            <Levels {...properties} box={box} />
            <Group name="Lamps" state={litOf(box)} />
          </div>
          <BoxNeedle {...properties} box={box} />
          <details>
            <summary>Gate, probe and faults</summary>
            <div className="box-groups">
              <BoxForce hands={hands} isDisabled={isDisabled} box={box} />
              <Treatment {...properties} box={box} />
              <BoxFaults hands={hands} isDisabled={isDisabled} box={box} />
            </div>
          </details>
        </>
      )}
    </>
  );
}

/**
 * The acts of a person at the simulated box, as a drawer at the lower edge.
 *
 * @satisfies SWR-CON-040
 */
export function Box({
  name,
  operation,
  freshness,
}: {
  name: string;
  operation: Operation;
  freshness: Freshness;
}) {
  const [isOpen, setIsOpen] = useState(false);
  const id = useId();
  return (
    <aside className="box" aria-label="Simulated box" data-open={isOpen}>
      <button
        type="button"
        className="box-handle"
        aria-expanded={isOpen}
        aria-controls={id}
        onClick={() => setIsOpen(!isOpen)}
      >
        {isOpen ? "Close" : "Open"} the simulated box
      </button>
      <div className="box-content" id={id} hidden={!isOpen}>
        {isOpen && (
          <>
            <h2 className="hidden">Simulated box “{name}”</h2>
            <Open operation={operation} freshness={freshness} />
          </>
        )}
      </div>
    </aside>
  );
}
