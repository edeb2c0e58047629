// SPDX-License-Identifier: Apache-2.0
import type { ReactNode } from "react";
import "./WideTable.css";

/** Columns of numbers stand on the right. */
export type Column = string | { number: string };

/** A table that scrolls by itself, by keys too, where the page is narrower. */
export function WideTable({
  label,
  columns,
  children,
}: {
  label: string;
  columns: readonly Column[];
  children: ReactNode;
}) {
  return (
    <div className="wide-table" role="region" aria-label={label} tabIndex={0}>
      <table>
        <thead>
          <tr>
            {columns.map((column) =>
              typeof column === "string" ? (
                <th key={column} scope="col">
                  {column}
                </th>
              ) : (
                <th key={column.number} scope="col" className="number">
                  {column.number}
                </th>
              ),
            )}
          </tr>
        </thead>
        <tbody>{children}</tbody>
      </table>
    </div>
  );
}
