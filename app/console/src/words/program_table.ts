// SPDX-License-Identifier: Apache-2.0
// A treatment program as it is written in the page: texts, until they are sent.
import type { ProgramRequest } from "@interface";
import { readNumbers } from "./format";

export interface StepText {
  depth: string;
  /** Empty for a robot that does not turn its needle. */
  angle: string;
  dwell: string;
  gate: boolean;
}

export const emptyStep: StepText = {
  depth: "",
  angle: "",
  dwell: "0",
  gate: false,
};

type Step = ProgramRequest["steps"][number];

function isStep(one: unknown): one is Step {
  if (typeof one !== "object" || one === null) {
    return false;
  }
  const { depth_mm, angle_deg, dwell_s, gate } = one as Partial<Step>;
  return (
    typeof depth_mm === "number" &&
    typeof dwell_s === "number" &&
    typeof gate === "boolean" &&
    (angle_deg === undefined || typeof angle_deg === "number")
  );
}

/** Steps of a file {"steps": [...]}; null if it is none. */
export function readProgram(text: string): StepText[] | null {
  try {
    const { steps } = JSON.parse(text) as { steps?: unknown };
    return Array.isArray(steps) && steps.length > 0 && steps.every(isStep)
      ? steps.map(({ depth_mm, angle_deg, dwell_s, gate }) => ({
          depth: String(depth_mm),
          angle: angle_deg === undefined ? "" : String(angle_deg),
          dwell: String(dwell_s),
          gate,
        }))
      : null;
  } catch {
    return null;
  }
}

/** Null while a step has a number missing. */
export function writeProgram(
  steps: readonly StepText[],
): ProgramRequest | null {
  const written = steps.map(({ depth, angle, dwell, gate }): Step | null => {
    const numbers = readNumbers(
      `${depth} ${dwell} ${angle}`,
      angle === "" ? 2 : 3,
    );
    const [depthNumber, dwellNumber, angleNumber] = numbers ?? [];
    return depthNumber === undefined || dwellNumber === undefined
      ? null
      : {
          depth_mm: depthNumber,
          ...(angleNumber !== undefined && { angle_deg: angleNumber }),
          dwell_s: dwellNumber,
          gate,
        };
  });
  const whole = written.filter((step) => step !== null);
  return whole.length > 0 && whole.length === steps.length
    ? { steps: whole }
    : null;
}
