// SPDX-License-Identifier: Apache-2.0
import type { Modes, Status } from "@interface";
import { words } from "../../words/format";
import { Shape } from "../../parts/drawn/Shape";

/**
 * Each motion that there is, and whether it may be commanded now, as the server says it.
 *
 * @satisfies SWR-CON-032
 */
export function ModeList({
  outlook,
  status,
  chosen,
  choose,
}: {
  outlook: Modes | null;
  status: Status;
  chosen: string;
  choose(name: string): void;
}) {
  const { mode: armed, order } = status;
  return (
    <fieldset className="modes">
      <legend className="hidden">Mode</legend>
      {outlook === null && <p>The allowed commands are not known yet.</p>}
      {outlook?.modes.map(({ name, reason }) => (
        <label key={name} className="mode" data-allowed={reason === null}>
          <input
            type="radio"
            name="mode"
            checked={name === chosen}
            onChange={() => choose(name)}
          />
          <strong>
            {words(name)}
            {name === armed.name && order !== "none" && (
              <span className="mode-armed"> {words(order)}</span>
            )}
          </strong>
          <span className="mode-reason">
            <Shape level={reason === null ? "active" : "unknown"} />{" "}
            {reason ?? "May be commanded."}
          </span>
        </label>
      ))}
    </fieldset>
  );
}
