// SPDX-License-Identifier: Apache-2.0
import { useId } from "react";
import { matrixText } from "../../words/format";

/** Four rows, as Slicer's Transforms pastes them; selected whole when it is clicked. */
export function Matrix({
  label,
  matrix,
}: {
  label: string;
  matrix: readonly number[];
}) {
  const id = useId();
  return (
    <div className="orders">
      <label htmlFor={id}>{label}</label>
      <textarea
        id={id}
        rows={4}
        cols={44}
        readOnly
        value={matrixText(matrix)}
        onFocus={({ target }) => target.select()}
      />
    </div>
  );
}
