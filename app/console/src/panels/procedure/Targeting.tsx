// SPDX-License-Identifier: Apache-2.0
import type { Targeting as TargetingData } from "@interface";
import {
  formatNumber,
  formatOrigin,
  formatPoint,
  originOf,
} from "../../words/format";
import { Matrix } from "../../parts/drawn/Matrix";
import { membranesText } from "./Membranes";
import { steeringText } from "./Steering";

function pointText(matrix: readonly number[] | null, missing: string): string {
  return matrix === null ? missing : formatPoint(originOf(matrix));
}

function proposedRegistrationText({ proposals }: TargetingData): string {
  return proposals.registration === null
    ? "none"
    : `at ${pointText(proposals.registration, "")} (decides nothing)${formatOrigin(proposals.registration_by)}`;
}

function proposedEntryText({ proposals }: TargetingData): string {
  return proposals.entry_mm === null
    ? "none"
    : `${formatPoint(proposals.entry_mm)} (decides nothing)${formatOrigin(proposals.entry_by)}`;
}

function proposalText({ proposals }: TargetingData): string {
  if (proposals.target_mm === null) {
    return "none";
  }
  const reach = proposals.is_reachable ? "reachable" : "not reachable";
  return `${formatPoint(proposals.target_mm)} (${reach})${formatOrigin(proposals.target_by)}`;
}

/** The point that decides how deep the needle goes; none until one is commanded or accepted. */
function entryText({ entry_mm: entry, entry_by: by }: TargetingData): string {
  return entry === null
    ? "none"
    : `${formatPoint(entry)} (decides the depth)${formatOrigin(by)}`;
}

function targetText({ target, target_by: by }: TargetingData): string {
  return pointText(target, "none") + formatOrigin(by);
}

/** The essentials of the registration. */
function registrationText(targeting: TargetingData): string {
  if (targeting.registration === null) {
    return "none";
  }
  const what = targeting.ignores_registration_rotation
    ? "accepted, its rotation ignored"
    : "accepted";
  return what + formatOrigin(targeting.registration_by);
}

/**
 * The lengths of the probe that all poses go by.
 *
 * @satisfies SWR-PROBE-009
 */
function probeText({ probe }: TargetingData): string {
  return probe
    .map(({ name, length_mm: length }) =>
      length === null
        ? `${name} unknown`
        : `${name} ${formatNumber(length, 3)} mm`,
    )
    .join(", ");
}

/** The matrices that exist now, as text that can be copied. */
function Matrices({ targeting }: { targeting: TargetingData }) {
  const matrices: [string, readonly number[] | null][] = [
    ["Scanner from z-frame (registration)", targeting.registration],
    ["Scanner from needle (now)", targeting.scanner_treatment],
    ["Scanner from target", targeting.target],
  ];
  return (
    <details>
      <summary>Matrices, in mm by rows</summary>
      {matrices.map(
        ([label, matrix]) =>
          matrix !== null && (
            <Matrix key={label} label={label} matrix={matrix} />
          ),
      )}
    </details>
  );
}

/**
 * Points are in mm, in scanner coordinates where the robot is registered. The sender and the age of each are shown.
 *
 * @satisfies SWR-CON-106
 * @satisfies SWR-IGTL-072
 */
export function Targeting({ targeting }: { targeting: TargetingData }) {
  const { distance_mm: distance } = targeting;
  const steering = steeringText(targeting);
  return (
    <>
      <dl className="facts">
        <dt>Registration</dt>
        <dd>{registrationText(targeting)}</dd>
        <dt>Probe</dt>
        <dd>{probeText(targeting)}</dd>
        <dt>Treatment point, scanner</dt>
        <dd>
          {pointText(
            targeting.scanner_treatment,
            "not homed, or not registered",
          )}
        </dd>
        <dt>Treatment point, base</dt>
        <dd>{pointText(targeting.zframe_treatment, "not homed")}</dd>
        <dt>Entry point</dt>
        <dd>{entryText(targeting)}</dd>
        <dt>Target</dt>
        <dd>{targetText(targeting)}</dd>
        {targeting.membranes !== null && (
          <>
            <dt>Membranes</dt>
            <dd>{membranesText(targeting.membranes)}</dd>
          </>
        )}
        {steering !== null && (
          <>
            <dt>Steering</dt>
            <dd>{steering}</dd>
          </>
        )}
        <dt>Distance to target</dt>
        <dd>{distance === null ? "–" : `${formatNumber(distance, 3)} mm`}</dd>
        <dt>Needle seen in the image</dt>
        <dd>{pointText(targeting.seen_needle, "none")}</dd>
        <dt>Proposed registration</dt>
        <dd>{proposedRegistrationText(targeting)}</dd>
        <dt>Proposed entry point</dt>
        <dd>{proposedEntryText(targeting)}</dd>
        <dt>Proposed target</dt>
        <dd>{proposalText(targeting)}</dd>
      </dl>
      <Matrices targeting={targeting} />
    </>
  );
}
