// SPDX-License-Identifier: Apache-2.0
import {
  useEffect,
  useId,
  useState,
  useSyncExternalStore,
  type ReactNode,
} from "react";
import type { Box as BoxState, BoxOrderRequest, BoxSlot } from "@interface";
import { BoxHands, type BoxView, type Handle, type Hold } from "../box";
import type { Freshness } from "../freshness";
import { mayCommand, obstacleOf, type Operation } from "../operation";
import { HoldButton } from "../parts/HoldButton";
import "./Box.css";

type Part = "card_fault" | "encoder_fault" | "motor_fault" | "switch_fault";
type Plug = NonNullable<BoxOrderRequest["plug"]>;

/** What can be wrong, as people say it. */
const faults: { [P in Part]: Record<BoxSlot[P], string> } = {
  card_fault: {
    normal: "works",
    silent: "does not answer",
    corrupt: "answers are damaged",
    foreign: "has another firmware",
  },
  encoder_fault: {
    normal: "works",
    stuck: "cable is cut",
    reversed: "lines are swapped",
    half: "loses every other edge",
  },
  motor_fault: {
    normal: "works",
    stuck: "cannot turn",
    half: "turns half as fast",
    twice: "turns twice as fast",
    runs: "runs without being asked",
    hot: "is too hot",
  },
  switch_fault: {
    normal: "works",
    stuck: "is always active",
    open: "wire is cut",
    chatter: "wire is loose",
    reversed: "is active where it should be free",
  },
};
const partNames: Record<Part, string> = {
  card_fault: "Card",
  encoder_fault: "Encoder",
  motor_fault: "Motor",
  switch_fault: "Switch",
};
const parts = Object.keys(partNames) as Part[];
const plugs: Record<Plug, string> = {
  none: "nothing",
  pwm: "pwm",
  non_pwm: "non-pwm",
  sensor: "sensor",
  high_frequency: "high frequency",
  analog: "analog",
};
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
  children: ReactNode;
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
        label={`Hold ${handle}`}
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
        Keep {handle} pressed
      </button>
    </Group>
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

/** What is either so or so, and what changes it. */
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

/** What few need. */
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

function nameOf({ slot, axis, card_type }: BoxSlot): string {
  return `${slot} ${axis ?? plugs[card_type]}`;
}

/** The parts of what is in a slot: only its card where no axis is connected. */
function partsOf({ axis, card_type }: BoxSlot): readonly Part[] {
  if (card_type === "none") {
    return [];
  }
  return axis === null ? ["card_fault"] : parts;
}

function Present({
  slots,
  hands,
  isDisabled,
}: {
  slots: readonly BoxSlot[];
  hands: BoxHands;
  isDisabled: boolean;
}) {
  const present = slots.flatMap((slot) =>
    partsOf(slot)
      .filter((part) => slot[part] !== "normal")
      .map((part) => ({ slot, part })),
  );
  return (
    <ul className="box-faults">
      {present.length === 0 && <li>Nothing is wrong at the box.</li>}
      {present.map(({ slot, part }) => {
        const text: Record<string, string> = faults[part];
        const name = `${nameOf(slot)}: ${partNames[part].toLowerCase()}`;
        return (
          <li key={`${slot.slot} ${part}`}>
            {name} {text[slot[part]]}{" "}
            <button
              type="button"
              disabled={isDisabled}
              aria-label={`Mend ${name}`}
              onClick={() =>
                void hands.order({ slot: slot.slot, [part]: "normal" })
              }
            >
              Mend
            </button>
          </li>
        );
      })}
    </ul>
  );
}

function Choices({ slot }: { slot: BoxSlot }) {
  return (
    <>
      {partsOf(slot).map((part) => (
        <optgroup key={part} label={partNames[part]}>
          {Object.entries(faults[part])
            .filter(([fault]) => fault !== "normal")
            .map(([fault, text]) => (
              <option key={fault} value={`${part} ${fault}`}>
                {partNames[part]} {text}
              </option>
            ))}
        </optgroup>
      ))}
      {slot.axis === null && (
        <optgroup label="Card in the slot">
          {Object.entries(plugs).map(([plug, name]) => (
            <option key={plug} value={`plug ${plug}`}>
              Put in: {name}
            </option>
          ))}
        </optgroup>
      )}
    </>
  );
}

function Faults({ hands, box, isDisabled }: WorkProperties) {
  const { slots } = box;
  const [number, setNumber] = useState(
    () => slots.find(({ axis }) => axis !== null)?.slot ?? 0,
  );
  const [choice, setChoice] = useState("");
  const slot = slots[number];
  if (slot === undefined) {
    return null;
  }
  const [member = "", value = ""] = choice.split(" ");
  return (
    <div className="box-group box-wide" role="group" aria-label="Faults">
      <label>
        <span className="box-name">Slot</span>
        <select
          value={number}
          disabled={isDisabled}
          onChange={(event) => {
            setNumber(Number(event.target.value));
            setChoice("");
          }}
        >
          {slots.map((one) => (
            <option key={one.slot} value={one.slot}>
              {nameOf(one)}
            </option>
          ))}
        </select>
      </label>
      <label>
        <span className="box-name">Fault</span>
        <select
          value={choice}
          disabled={isDisabled}
          onChange={(event) => setChoice(event.target.value)}
        >
          <option value="">Choose…</option>
          <Choices slot={slot} />
        </select>
      </label>
      <button
        type="button"
        disabled={isDisabled || choice === ""}
        onClick={() => void hands.order({ slot: number, [member]: value })}
      >
        Do it
      </button>
      <Present slots={slots} hands={hands} isDisabled={isDisabled} />
    </div>
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
            <Held {...properties} box={box} handle="pedal" />
            <Held {...properties} box={box} handle="button" />
            <Levels {...properties} box={box} />
          </div>
          <details>
            <summary>Gate, probe and faults</summary>
            <div className="box-groups">
              <Treatment {...properties} box={box} />
              <Faults {...properties} box={box} />
            </div>
          </details>
        </>
      )}
    </>
  );
}

/**
 * What a person does at the simulated box, as a drawer at the lower edge.
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
