// SPDX-License-Identifier: Apache-2.0
// A question "what if": one input, chosen where time stands still, and the first thing that it changes.
import { useId, useState, type FormEvent } from "react";
import { linkOf } from "./address";
import { MOST_SECONDS, type Question } from "./question";
import type { RobotTransport, RobotView } from "./robot_transport";

const USUAL: Question = { input: "", seconds: 10 };

interface Properties {
  robot: Pick<RobotTransport, "compare">;
  view: RobotView;
  /** Question of the link by which the page was opened; null: it asks nothing. */
  asked: Question | null;
}

function Said({ compared }: Pick<RobotView, "compared">) {
  if (compared === null) {
    return null;
  }
  const { problem, lines, scene, question } = compared;
  return problem !== null ? (
    <p role="alert">{problem}</p>
  ) : (
    <>
      <div role="status" className="simulation-lines">
        {lines.map((line) => (
          <p key={line}>{line}</p>
        ))}
        {lines.length === 0 && (
          <p>
            Nothing differs in {question.seconds} s with “{question.input}”.
          </p>
        )}
      </div>
      {scene !== null && (
        <label className="simulation-link">
          Link to this question{" "}
          <input
            readOnly
            value={linkOf(scene, { ...question, cycle: compared.cycle })}
            onFocus={({ target }) => target.select()}
          />
        </label>
      )}
    </>
  );
}

/** @satisfies SWR-SITE-033 */
export function WhatIf({ robot, view, asked }: Properties) {
  const [{ input, seconds }, setQuestion] = useState(asked ?? USUAL);
  const list = useId();
  const ask = (event: FormEvent) => {
    event.preventDefault();
    robot.compare({ input, seconds });
  };
  return (
    <form
      className="simulation-bar"
      aria-label="What would be if"
      onSubmit={ask}
    >
      <label>
        What if{" "}
        <input
          required
          list={list}
          value={input}
          onChange={({ target }) =>
            setQuestion({ input: target.value, seconds })
          }
        />
      </label>
      <datalist id={list}>
        {view.inputs.map((one) => (
          <option key={one} value={one} />
        ))}
      </datalist>
      <label>
        Compared for, s{" "}
        <input
          type="number"
          required
          min={1}
          max={MOST_SECONDS}
          value={seconds}
          onChange={({ target }) =>
            setQuestion({ input, seconds: Number(target.value) })
          }
        />
      </label>
      <button type="submit" disabled={view.share !== 0}>
        Compare
      </button>
      {view.share !== 0 && <span>Pause first.</span>}
      <Said compared={view.compared} />
    </form>
  );
}
