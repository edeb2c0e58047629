// SPDX-License-Identifier: Apache-2.0
import type { Page } from "@interface";
import { formatDuration } from "../../words/format";
import { Shape } from "../../parts/drawn/Shape";
import { WideTable } from "../../parts/WideTable";

const columns = ["Account", "Commands", { number: "Here for" }];

/**
 * The pages of the console at which a user is logged in.
 *
 * @satisfies SWR-CON-037
 */
export function Pages({
  pages,
  own,
}: {
  pages: readonly Page[];
  /** Number of this page. */
  own: number;
}) {
  if (pages.length === 0) {
    return <p>Nobody is logged in.</p>;
  }
  return (
    <WideTable label="Pages" columns={columns}>
      {pages.map((page) => (
        <tr key={page.number}>
          <th scope="row">
            {page.account}
            {page.number === own && ", this page"}
          </th>
          <td>
            <Shape level={page.has_authority ? "active" : "unknown"} />
            {page.has_authority ? "commands" : "no"}
          </td>
          <td className="number">{formatDuration(page.age_s * 1000)}</td>
        </tr>
      ))}
    </WideTable>
  );
}
