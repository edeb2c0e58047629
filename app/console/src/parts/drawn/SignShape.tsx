// SPDX-License-Identifier: Apache-2.0
import type { SignKind } from "../../words/sign";

const RING = "M24 4a20 20 0 1 0 .01 0zm0 7a13 13 0 1 1-.01 0z";

const outlines: Readonly<Record<SignKind, string>> = {
  moving: "M4 6l18 18L4 42zM24 6l18 18-18 18z",
  may: "M10 4l32 20-32 20z",
  armed: "M10 4l32 20-32 20zm6 11v18l15-9z",
  stands: RING,
  estop: "M24 2a22 22 0 1 0 .01 0zM9 19h30v10H9z",
  lost: "M10 3l14 14L38 3l7 7-14 14 14 14-7 7-14-14-14 14-7-7 14-14L3 10z",
  fault: "M15 3h18l12 12v18L33 45H15L3 33V15zm6 7v16h6V10zm0 21v6h6v-6z",
  stale: "M9 3h30v8L28 24l11 13v8H9v-8l11-13L9 11z",
  absent: "M6 20h36v8H6z",
};

/** Each kind has an outline that no other thing on the page has. */
export function SignShape({ kind }: { kind: SignKind }) {
  return (
    <svg
      className="sign-shape"
      viewBox="0 0 48 48"
      fillRule="evenodd"
      aria-hidden="true"
    >
      <path d={outlines[kind]} />
    </svg>
  );
}
