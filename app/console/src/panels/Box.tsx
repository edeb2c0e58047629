// SPDX-License-Identifier: Apache-2.0
import { useEffect, useId, useState, useSyncExternalStore } from "react";
import type { Box as BoxState, BoxOrderRequest, BoxSlot } from "@interface";
import { BoxHands, type BoxView, type Handle } from "../box";
import { words } from "../format";
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
  off: "Gate says nothing",
  dose: "Dose reached",
  stop: "Gate says stop",
};
const PUSH_MM = 10;

interface WorkProperties {
  hands: BoxHands;
  view: BoxView;
  box: BoxState;
  isDisabled: boolean;
}

function stateOf(isPressed: boolean, holder: number, isHere: boolean): string {
  if (!isPressed) {
    return "released";
  }
  if (holder === 0) {
    return "pressed at the box";
  }
  return isHere ? "pressed by this page" : "pressed by another page";
}

function Held({
  hands,
  view,
  box,
  isDisabled,
  handle,
}: WorkProperties & { handle: Handle }) {
  const isHere = view[handle] !== "none";
  const state = stateOf(
    box[`is_${handle}_pressed`],
    box[`${handle}_holder`],
    isHere,
  );
  const isLatched = view[handle] === "latched";
  return (
    <div className="box-group" role="group" aria-label={words(handle)}>
      <p>
        <span className="box-name">{handle}</span>{" "}
        <strong className="box-state">{state}</strong>
      </p>
      <HoldButton
        label={`Hold ${handle}`}
        isHeld={isHere}
        isDisabled={isDisabled}
        onHold={() => void hands.hold(handle, "held")}
        onDrop={() => void hands.drop(handle)}
      />
      <button
        type="button"
        role="switch"
        aria-checked={isLatched}
        disabled={isDisabled || view[handle] === "held"}
        onClick={() =>
          void (isLatched ? hands.drop(handle) : hands.hold(handle, "latched"))
        }
      >
        {isLatched ? `Let go of ${handle}` : `Keep ${handle} pressed`}
      </button>
    </div>
  );
}

/** What is either so or so, and what changes it. */
function Levels({ hands, box, isDisabled }: WorkProperties) {
  const order = (one: BoxOrderRequest) => () => void hands.order(one);
  const isPulled = box.is_estop_pulled;
  const isScanning = box.is_scanner_active;
  const isFree = box.probe === "free";
  return (
    <>
      <div className="box-group" role="group" aria-label="E-stop">
        <p>
          <span className="box-name">e-stop</span>{" "}
          <strong className="box-state">
            {isPulled ? "pulled" : "not pulled"}
          </strong>
        </p>
        <button
          type="button"
          disabled={isDisabled}
          onClick={order({ estop: isPulled ? "reset" : "pull" })}
        >
          {isPulled ? "Reset e-stop" : "Pull e-stop"}
        </button>
      </div>
      <div className="box-group" role="group" aria-label="Scanner">
        <p>
          <span className="box-name">scanner</span>{" "}
          <strong className="box-state">
            {isScanning ? "acquires" : "rests"}
          </strong>
        </p>
        <button
          type="button"
          disabled={isDisabled}
          onClick={order({ scanner: isScanning ? "off" : "on" })}
        >
          {isScanning ? "Scanner off" : "Scanner on"}
        </button>
      </div>
      <div className="box-group" role="group" aria-label="Gate">
        <label>
          <span className="box-name">gate of a treatment</span>
          <select
            value={box.gate}
            disabled={isDisabled}
            onChange={(event) =>
              void hands.order({
                gate: event.target.value as BoxState["gate"],
              })
            }
          >
            {Object.entries(gates).map(([gate, name]) => (
              <option key={gate} value={gate}>
                {name}
              </option>
            ))}
          </select>
        </label>
      </div>
      <div className="box-group" role="group" aria-label="Probe">
        <p>
          <span className="box-name">probe</span>{" "}
          <strong className="box-state">
            {isFree ? "in the hand" : "coupled to its axis"}
          </strong>
        </p>
        <button
          type="button"
          disabled={isDisabled}
          onClick={order({ probe: isFree ? "coupled" : "free" })}
        >
          {isFree ? "Couple probe" : "Free probe"}
        </button>
        {[PUSH_MM, -PUSH_MM].map((mm) => (
          <button
            key={mm}
            type="button"
            disabled={isDisabled}
            onClick={order({ push_mm: mm })}
          >
            Push {PUSH_MM} mm {mm > 0 ? "in" : "out"}
          </button>
        ))}
      </div>
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
        <span className="box-name">slot</span>
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
        <span className="box-name">fault</span>
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
        <div className="box-groups">
          <Held {...properties} box={box} handle="pedal" />
          <Held {...properties} box={box} handle="button" />
          <Levels {...properties} box={box} />
          <Faults {...properties} box={box} />
        </div>
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
            <h2>Simulated box “{name}”</h2>
            <Open operation={operation} freshness={freshness} />
          </>
        )}
      </div>
    </aside>
  );
}
