// SPDX-License-Identifier: Apache-2.0
import { useId, useState, useSyncExternalStore, type FormEvent } from "react";
import { commands, LogNoteRequestBytes } from "@interface";
import { mayCommand, type Operation } from "../../state/operation";

const encoder = new TextEncoder();

/**
 * A note of who looks, into the log. It commands nothing and needs no authority.
 *
 * @satisfies SWR-CON-038
 */
export function LogNote({ operation }: { operation: Operation }) {
  const { session, page } = operation;
  const view = useSyncExternalStore(session.subscribe, session.getView);
  const [text, setText] = useState("");
  const [problem, setProblem] = useState<string | null>(null);
  const id = useId();
  const left = LogNoteRequestBytes.text - encoder.encode(text).length;
  const isAllowed = mayCommand(view.session);
  const write = async (event: FormEvent) => {
    event.preventDefault();
    const refusal = await page.act(commands.NOTE.path, { text });
    setProblem(refusal);
    if (refusal === null) {
      setText("");
    }
  };
  return (
    <form className="orders" onSubmit={(event) => void write(event)}>
      <label htmlFor={id}>Note</label>
      <input
        id={id}
        className="log-note"
        value={text}
        disabled={!isAllowed}
        aria-describedby={`${id}-left`}
        onChange={(event) => setText(event.target.value)}
      />
      <button type="submit" disabled={!isAllowed || text === "" || left < 0}>
        {commands.NOTE.label}
      </button>
      <p className="orders-refusal" id={`${id}-left`}>
        {isAllowed
          ? `${left} bytes left.`
          : "Log in as operator to write into the log."}
      </p>
      {problem !== null && (
        <p className="order-problem" role="alert">
          {problem}
        </p>
      )}
    </form>
  );
}
