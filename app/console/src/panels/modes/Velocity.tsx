// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";
import { commands, type Axis, type Robot } from "@interface";
import { formatSpeed, readNumbers } from "../../words/format";
import { reasonAgainst, useRobot } from "../../state/outlook";
import { Order, Orders } from "../../parts/Order";
import type { ModePanelProperties } from "./mode_panel";

const units = { mm: "mm", deg: "degrees" } as const;

type Bound = "time_s" | "way";

interface AxisSpeed {
  axis: string;
  speed_per_s: number | undefined;
  unit: Axis["unit"];
}

/** The input that is missing before it can be commanded, or null. Limits are the server's to judge. */
function missingOf(
  speeds: readonly AxisSpeed[],
  bound: Bound,
  amount: number | undefined,
): string | null {
  const bad = speeds.find(({ speed_per_s }) => speed_per_s === undefined);
  if (speeds.length === 0) {
    return "Write the speed of an axis.";
  }
  if (bad !== undefined) {
    return `The speed of ${bad.axis} is no number.`;
  }
  if (bound === "way" && speeds.length > 1) {
    return "A way is of one axis alone.";
  }
  return amount === undefined ? "Write how long or how far." : null;
}

function SpeedRow({
  axis,
  robot,
  text,
  setText,
}: {
  axis: Axis;
  robot: Robot | null;
  text: string;
  setText(text: string): void;
}) {
  const most = robot?.axes.find(({ name }) => name === axis.name)?.speed_per_s;
  return (
    <li>
      <label>
        <span className="speed-axis">{axis.name}</span>
        <input
          inputMode="decimal"
          size={8}
          value={text}
          onChange={(event) => setText(event.target.value)}
        />{" "}
        {units[axis.unit]} per second
      </label>
      {most !== undefined && (
        <span className="speed-most">
          at most {formatSpeed(most, axis.unit)}
        </span>
      )}
    </li>
  );
}

function speedsOf(
  axes: readonly Axis[],
  texts: Readonly<Record<string, string>>,
): AxisSpeed[] {
  return axes
    .filter(({ name }) => (texts[name] ?? "").trim() !== "")
    .map(({ name, unit }) => ({
      axis: name,
      speed_per_s: readNumbers(texts[name] ?? "", 1)?.[0],
      unit,
    }));
}

function BoundChoice({
  bound,
  choose,
}: {
  bound: Bound;
  choose: (bound: Bound) => void;
}) {
  return (
    <label>
      For a{" "}
      <select
        value={bound}
        onChange={(event) => choose(event.target.value as Bound)}
      >
        <option value="time_s">time</option>
        <option value="way">way</option>
      </select>
    </label>
  );
}

/**
 * One axis or several at a speed each, for a time, or one of them for a way.
 *
 * @satisfies SWR-CON-035
 */
export function Velocity({
  robot,
  operation,
  commanding,
  outlook,
}: ModePanelProperties) {
  const facts = useRobot(operation.page, robot.status.boot_id);
  const [texts, setTexts] = useState<Readonly<Record<string, string>>>({});
  const [bound, setBound] = useState<Bound>("time_s");
  const [amountText, setAmountText] = useState("");
  const { axes } = robot.motors;
  const speeds = speedsOf(axes, texts);
  const amount = readNumbers(amountText, 1)?.[0];
  const moved = axes.find(({ name }) => name === speeds[0]?.axis);
  const refusal = reasonAgainst(outlook, "VELOCITY");
  return (
    <>
      <ul className="speeds" aria-label="Speeds; the sign is the way">
        {axes.map((axis) => (
          <SpeedRow
            key={axis.name}
            axis={axis}
            robot={facts}
            text={texts[axis.name] ?? ""}
            setText={(text) => setTexts({ ...texts, [axis.name]: text })}
          />
        ))}
      </ul>
      <Orders name="How long">
        <BoundChoice bound={bound} choose={setBound} />
        <label>
          of{" "}
          <input
            inputMode="decimal"
            size={8}
            value={amountText}
            onChange={(event) => setAmountText(event.target.value)}
          />{" "}
          {bound === "time_s"
            ? "seconds, ramps included"
            : units[moved?.unit ?? "mm"]}
        </label>
        <Order
          commanding={commanding}
          path={commands.VELOCITY.path}
          fields={{
            speeds,
            [bound]: amount,
            ...(bound === "way" && { unit: moved?.unit }),
          }}
          refusal={refusal ?? missingOf(speeds, bound, amount)}
        >
          {commands.VELOCITY.label}
        </Order>
      </Orders>
    </>
  );
}
