// SPDX-License-Identifier: Apache-2.0
import { useEffect, useId, useRef, useState } from "react";
import { views } from "../views/views";
import { glossary } from "./glossary";
import { letterOf } from "./keys";
import "./help.css";

/** Goes back, when it is closed, to where the keyboard was. */
function useOpenDialog(onClose: () => void) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    const closeByEscape = ({ key }: KeyboardEvent) => {
      if (key === "Escape") {
        onClose();
      }
    };
    dialog.current?.querySelector("button")?.focus();
    window.addEventListener("keydown", closeByEscape);
    return () => {
      window.removeEventListener("keydown", closeByEscape);
      if (before instanceof HTMLElement) {
        before.focus();
      }
    };
  }, [onClose]);
  return dialog;
}

function Keys({
  areOn,
  setOn,
}: {
  areOn: boolean;
  setOn: (areOn: boolean) => void;
}) {
  return (
    <section>
      <h3>Keys</h3>
      <label className="help-switch">
        <input
          type="checkbox"
          checked={areOn}
          onChange={(event) => setOn(event.target.checked)}
        />
        Keys of this table but Esc, Tab and Enter
      </label>
      <dl className="help-keys">
        <dt>
          <kbd>Esc</kbd>
        </dt>
        <dd>Stops all motion, from anywhere, always. It closes this too.</dd>
        <dt>
          <kbd>Tab</kbd>, <kbd>Shift</kbd>+<kbd>Tab</kbd>
        </dt>
        <dd>To the next and the last control</dd>
        <dt>
          <kbd>Enter</kbd>, <kbd>Space</kbd>
        </dt>
        <dd>Presses a button</dd>
        <dt>
          <kbd>?</kbd>
        </dt>
        <dd>This help</dd>
        {views.map((view) => (
          <div key={view.id}>
            <dt>
              <kbd>g</kbd> <kbd>{letterOf(view)}</kbd>
            </dt>
            <dd>View {view.title}</dd>
          </div>
        ))}
      </dl>
    </section>
  );
}

function Glossary() {
  const [sought, setSought] = useState("");
  const text = sought.trim().toLowerCase();
  const found = glossary.filter(({ term, says }) =>
    `${term} ${says}`.toLowerCase().includes(text),
  );
  return (
    <section>
      <h3>Words</h3>
      <label>
        Find{" "}
        <input
          type="search"
          value={sought}
          onChange={(event) => setSought(event.target.value)}
        />
      </label>
      <dl className="help-words">
        {found.map(({ term, says }) => (
          <div key={term}>
            <dt>{term}</dt>
            <dd>{says}</dd>
          </div>
        ))}
      </dl>
      {found.length === 0 && <p role="status">There is no such word here.</p>}
    </section>
  );
}

/**
 * Not modal: STOP stays in reach.
 *
 * @satisfies SWR-CON-023
 */
export function HelpSheet({
  areKeysOn,
  setKeysOn,
  onClose,
  onTour,
}: {
  areKeysOn: boolean;
  setKeysOn: (areOn: boolean) => void;
  onClose: () => void;
  onTour: () => void;
}) {
  const dialog = useOpenDialog(onClose);
  const id = useId();
  return (
    <dialog open ref={dialog} className="help" aria-labelledby={id}>
      <div className="help-head">
        <h2 id={id}>Help</h2>
        <button type="button" onClick={onClose}>
          Close
        </button>
      </div>
      <section>
        <h3>First steps</h3>
        <p>
          A tour of this page, in a minute. The manual is docs/user-manual.md.
        </p>
        <button type="button" onClick={onTour}>
          Show me the page
        </button>
      </section>
      <Keys areOn={areKeysOn} setOn={setKeysOn} />
      <Glossary />
    </dialog>
  );
}
