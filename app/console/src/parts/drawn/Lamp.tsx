// SPDX-License-Identifier: Apache-2.0
import type { LampProperties } from "../../state/lamps";
import { Shape } from "./Shape";

/** A shape, a label and a word. The colour only repeats what the shape says. */
export function Lamp({ label, level, word, detail }: LampProperties) {
  return (
    <li className="lamp" data-level={level}>
      <Shape level={level} />
      <span className="lamp-label">{label}</span>
      <span>
        <span className="lamp-word">{word}</span>
        {detail !== undefined && <span className="lamp-detail">{detail}</span>}
      </span>
    </li>
  );
}
