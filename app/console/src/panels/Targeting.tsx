// SPDX-License-Identifier: Apache-2.0
import type { Targeting as TargetingData } from "@interface";
import { formatNumber, formatPoint, originOf } from "../format";

function pointText(matrix: readonly number[] | null, missing: string): string {
  return matrix === null ? missing : formatPoint(originOf(matrix));
}

function proposalText({ proposals }: TargetingData): string {
  if (proposals.target_mm === null) {
    return "none";
  }
  const reach = proposals.is_reachable ? "reachable" : "not reachable";
  return `${formatPoint(proposals.target_mm)} (${reach})`;
}

/** Points are in mm, in scanner coordinates where the robot is registered. */
export function Targeting({ targeting }: { targeting: TargetingData }) {
  const { distance_mm: distance } = targeting;
  return (
    <dl className="facts">
      <dt>Registration</dt>
      <dd>{targeting.registration === null ? "none" : "accepted"}</dd>
      <dt>Treatment point, scanner</dt>
      <dd>
        {pointText(targeting.scanner_treatment, "not homed, or not registered")}
      </dd>
      <dt>Treatment point, base</dt>
      <dd>{pointText(targeting.zframe_treatment, "not homed")}</dd>
      <dt>Target</dt>
      <dd>{pointText(targeting.target, "none")}</dd>
      <dt>Distance to target</dt>
      <dd>{distance === null ? "–" : `${formatNumber(distance, 3)} mm`}</dd>
      <dt>Proposed target</dt>
      <dd>{proposalText(targeting)}</dd>
    </dl>
  );
}
