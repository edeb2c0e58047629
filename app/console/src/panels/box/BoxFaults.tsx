// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";
import type { Box, BoxOrderRequest, BoxSlot } from "@interface";
import type { BoxHands } from "../../state/box";

type Part = "card_fault" | "encoder_fault" | "motor_fault" | "switch_fault";
type Plug = NonNullable<BoxOrderRequest["plug"]>;

/** The faults that can be set, in plain words. */
const faults: { [P in Part]: Record<BoxSlot[P], string> } = {
  card_fault: {
    normal: "works",
    silent: "does not answer",
    corrupt: "answers are damaged",
    foreign: "has another firmware",
    deaf: "hears no command",
    noisy: "hears damaged commands",
    warm: "has a warm driver",
    hot: "has a driver that is too hot",
    low: "has a low supply",
    high: "has a high supply",
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
interface FaultsProperties {
  hands: BoxHands;
  box: Box;
  isDisabled: boolean;
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

/** The faults of the simulated box, and those that can be set. */
export function BoxFaults({ hands, box, isDisabled }: FaultsProperties) {
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
