// SPDX-License-Identifier: Apache-2.0
import { useId, useState } from "react";
import {
  commands,
  type Membrane,
  type Membranes,
  type Modes,
} from "@interface";
import { formatNumber, readNumbers, words } from "../../words/format";
import type { Commanding } from "../../state/operation";
import { Order } from "../../parts/Order";
import { reasonAgainst } from "../../state/outlook";

const MOST = 8;

function millimetres(depth: number): string {
  return `${formatNumber(depth, 1)} mm`;
}

function membraneText({ depth_mm: depth, found_mm: found, state }: Membrane) {
  const became =
    found === null
      ? words(state).toLowerCase()
      : `found at ${millimetres(found)}`;
  return `${millimetres(depth)} ${became}`;
}

function insertionText({ depth_mm: depth, least_fall_mn: least }: Membranes) {
  return depth === null || least === null
    ? ""
    : ` The needle is ${millimetres(depth)} deep; a force that falls by less than ${least} mN is not found.`;
}

/** All that is expected and was found, as one text. */
export function membranesText(membranes: Membranes): string {
  const { expected, left, unexpected } = membranes;
  const list =
    expected.length === 0
      ? "none expected"
      : `${expected.map(membraneText).join(", ")}; ${left} left`;
  return `${list}; ${unexpected} unexpected. ${membranes.says}${insertionText(membranes)}`;
}

/** The depths in the text; null: it is no list of depths, as with "20,5", which may be one or two. */
function readDepths(text: string): number[] | null {
  if (/\d,\d/.test(text)) return null;
  const count = text.trim() === "" ? 0 : text.trim().split(/[\s,;]+/).length;
  return count === 0 ? [] : count > MOST ? null : readNumbers(text, count);
}

/**
 * Depths at which membranes are expected, below the entry point; an empty field expects none.
 *
 * @satisfies SWR-PUNCT-620
 */
export function MembraneOrder({
  membranes,
  outlook,
  commanding,
}: {
  membranes: Membranes;
  outlook: Modes | null;
  commanding: Commanding;
}) {
  const [text, setText] = useState(
    membranes.expected.map((one) => formatNumber(one.depth_mm, 1)).join(" "),
  );
  const id = useId();
  const depths = readDepths(text);
  const missing =
    depths === null
      ? `Write at most ${MOST} depths in mm, with a space between two.`
      : null;
  return (
    <div className="orders">
      <label htmlFor={id}>Membranes, mm below the entry point</label>
      <input
        id={id}
        size={32}
        value={text}
        onChange={(event) => setText(event.target.value)}
      />
      <Order
        commanding={commanding}
        path={commands.MEMBRANES.path}
        fields={{ depths_mm: depths ?? [] }}
        refusal={reasonAgainst(outlook, "MEMBRANES") ?? missing}
      >
        {commands.MEMBRANES.label}
      </Order>
    </div>
  );
}
