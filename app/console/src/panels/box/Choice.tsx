// SPDX-License-Identifier: Apache-2.0
import type { BoxOrderRequest } from "@interface";
import type { BoxHands } from "../../state/box";

interface ChoiceProperties {
  name: string;
  /** The one that is now, and all by their texts. */
  value: string;
  texts: ReadonlyMap<string, string>;
  isDisabled: boolean;
  onChoose: (value: string) => void;
}

export function Choice({
  name,
  value,
  texts,
  isDisabled,
  onChoose,
}: ChoiceProperties) {
  return (
    <div className="box-group" role="group" aria-label={name}>
      <label>
        <span className="box-name">{name}</span>
        <select
          value={value}
          disabled={isDisabled}
          onChange={(event) => onChoose(event.target.value)}
        >
          {[...texts].map(([one, text]) => (
            <option key={one} value={one}>
              {text}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}

/** Orders to the box that are a number. */
type NumberOrder = {
  [Name in keyof BoxOrderRequest]-?: number extends BoxOrderRequest[Name]
    ? Name
    : never;
}[keyof BoxOrderRequest];

export interface NumberChoiceProperties {
  hands: BoxHands;
  name: string;
  order: NumberOrder;
  value: number;
  /** Values to choose from; the present one is added. */
  numbers: readonly number[];
  text: (value: number) => string;
  isDisabled: boolean;
}

/** A number of the box, and the order that changes it. */
export function NumberChoice({
  hands,
  name,
  order,
  value,
  numbers,
  text,
  isDisabled,
}: NumberChoiceProperties) {
  const present = numbers.includes(value) ? [] : [value];
  return (
    <Choice
      name={name}
      value={String(value)}
      texts={
        new Map([...present, ...numbers].map((one) => [String(one), text(one)]))
      }
      isDisabled={isDisabled}
      onChoose={(one) => void hands.order({ [order]: Number(one) })}
    />
  );
}
