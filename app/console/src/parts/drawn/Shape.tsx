// SPDX-License-Identifier: Apache-2.0
import type { Level } from "../../state/lamps";

const outlines: Readonly<Record<Level, string>> = {
  normal: "M10 3a7 7 0 1 0 0.01 0z",
  active: "M10 1l9 9-9 9-9-9z",
  attention: "M10 2l9 16H1z",
  fault: "M6 1h8l5 5v8l-5 5H6l-5-5V6z",
  unknown: "M3 8h14v4H3z",
};

/** Circle: as usual. Diamond: in use. Triangle: look. Octagon: fault. Bar: not there. */
export function Shape({ level }: { level: Level }) {
  return (
    <svg
      className="shape"
      data-shape={level}
      viewBox="0 0 20 20"
      aria-hidden="true"
    >
      <path d={outlines[level]} />
    </svg>
  );
}
