// SPDX-License-Identifier: Apache-2.0
import type { Box } from "@interface";
import type { BoxHands } from "../../state/box";
import { Choice, NumberChoice } from "./Choice";
import { hasForceSensor } from "./force";

type Cell = "force_hand" | "force_needle";

const cellNames: Record<Cell, string> = {
  force_hand: "Load cell of the hand",
  force_needle: "Load cell of the needle",
};
const cells = Object.keys(cellNames) as Cell[];

const faults: Record<Box[Cell], string> = {
  normal: "works",
  stuck: "reading is stuck",
  broken: "wire is cut, reads nothing",
  full: "wire is cut, reads all",
  step: "zero has jumped",
  drift: "zero wanders",
  noisy: "is noisy",
};

/** Grips that can be chosen, mN; below 0 the hand pulls. */
const grips = [500, 1000, 2000, 3000, 5000, 10000, -3000];

function gripText(mn: number): string {
  return `${mn < 0 ? "pulls" : "presses"} with ${Math.abs(mn) / 1000} N`;
}

interface ForceProperties {
  hands: BoxHands;
  box: Box;
  isDisabled: boolean;
}

function Tissue({ hands, box, isDisabled }: ForceProperties) {
  const isNone = box.layers === 0;
  return (
    <div className="box-group" role="group" aria-label="Tissue">
      <p>
        <span className="box-name">Tissue</span>{" "}
        <strong>{isNone ? "none" : `layers: ${box.layers}`}</strong>
      </p>
      <button
        type="button"
        disabled={isDisabled || isNone}
        onClick={() => void hands.order({ tissue: "whole" })}
      >
        Make tissue whole
      </button>
      <button
        type="button"
        disabled={isDisabled}
        onClick={() => void hands.order({ tissue: isNone ? "usual" : "none" })}
      >
        {isNone ? "Put tissue there" : "Take tissue away"}
      </button>
    </div>
  );
}

/** The force of the hand that holds the handle. */
export function Grip({ hands, box, isDisabled }: ForceProperties) {
  return (
    <NumberChoice
      hands={hands}
      order="grip_mn"
      name="Hand"
      value={box.grip_mn}
      numbers={grips}
      text={gripText}
      isDisabled={isDisabled}
    />
  );
}

/**
 * The tissue in front of the needle, and faults of the load cells; where there is a force sensor.
 *
 * @satisfies SWR-BOX-534
 */
export function BoxForce(properties: ForceProperties) {
  const { hands, box, isDisabled } = properties;
  if (!hasForceSensor(box)) {
    return null;
  }
  return (
    <>
      <Tissue {...properties} />
      {cells.map((cell) => (
        <Choice
          key={cell}
          name={cellNames[cell]}
          value={box[cell]}
          texts={new Map(Object.entries(faults))}
          isDisabled={isDisabled}
          onChoose={(fault) => void hands.order({ [cell]: fault })}
        />
      ))}
    </>
  );
}
