// SPDX-License-Identifier: Apache-2.0

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

interface NumberChoiceProperties {
  name: string;
  value: number;
  /** Those that can be chosen; the present one is added. */
  numbers: readonly number[];
  text: (value: number) => string;
  isDisabled: boolean;
  onChoose: (value: number) => void;
}

export function NumberChoice({
  name,
  value,
  numbers,
  text,
  isDisabled,
  onChoose,
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
      onChoose={(one) => onChoose(Number(one))}
    />
  );
}
