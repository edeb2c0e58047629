// SPDX-License-Identifier: Apache-2.0
// Rule under test: help explains each key and word, can be reached and left by the keyboard, and its keys switched off.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { systemLamps } from "../state/lamps";
import { makeStatus } from "../testing/robot";
import { views } from "../views/views";
import { glossary } from "./glossary";
import { Help } from "./Help";
import { letterOf } from "./keys";
import { stops } from "./stops";

function press(key: string, target: Element | Window = window): void {
  fireEvent.keyDown(target, { key });
}

function findSheet(): Promise<HTMLElement> {
  return screen.findByRole("dialog", { name: "Help" });
}

beforeEach(() => {
  localStorage.clear();
  window.location.hash = "";
});

afterEach(cleanup);

test("SWR-CON-023 the question mark opens the help, Escape closes it, and focus goes back", async () => {
  render(<Help />);
  const button = screen.getByRole("button", { name: /Help/ });
  button.focus();
  press("?");
  await findSheet();
  expect(document.activeElement?.textContent).toBe("Close");
  press("Escape");
  expect(screen.queryByRole("dialog")).toBeNull();
  expect(document.activeElement).toBe(button);
});

test("SWR-CON-023 no key counts while somebody types", () => {
  render(
    <>
      <Help />
      <input aria-label="Name" />
    </>,
  );
  const input = screen.getByLabelText("Name");
  press("?", input);
  press("g", input);
  press("m", input);
  expect(screen.queryByRole("dialog")).toBeNull();
  expect(window.location.hash).toBe("");
});

test("SWR-CON-023 g and a letter of its own lead to each view", () => {
  render(<Help />);
  for (const view of views) {
    press("g");
    press(letterOf(view));
    expect(window.location.hash).toBe(`#${view.id}`);
  }
  const letters = views.map(letterOf);
  expect(new Set(letters).size).toBe(letters.length);
});

test("SWR-CON-023 the keys can be switched off, and stay off", async () => {
  const { unmount } = render(<Help />);
  press("?");
  await findSheet();
  fireEvent.click(screen.getByRole("checkbox"));
  unmount();
  render(<Help />);
  press("?");
  press("g");
  press("m");
  expect(screen.queryByRole("dialog")).toBeNull();
  expect(window.location.hash).toBe("");
  fireEvent.click(screen.getByRole("button", { name: /Help/ }));
  await findSheet();
});

test("SWR-CON-023 the words can be searched", async () => {
  render(<Help />);
  press("?");
  await findSheet();
  fireEvent.change(screen.getByRole("searchbox"), {
    target: { value: "lags behind" },
  });
  const terms = screen.getAllByRole("term").map((term) => term.textContent);
  expect(terms).toContain("following error");
  expect(terms).not.toContain("workphase");
});

test("SWR-CON-023 each lamp, workphase and sentence of ours has its words", () => {
  const terms = glossary.map(({ term }) => term.toLowerCase()).join(", ");
  const lamps = systemLamps(makeStatus()).map(({ label }) => label);
  for (const word of [
    ...lamps.map((label) => label.replace(/s$/, "")),
    "workphase",
    "registration",
    "entry point",
    "permit",
    "following error",
    "unverified",
    "taken in place",
  ]) {
    expect(terms).toContain(word.toLowerCase());
  }
});

test("SWR-CON-023 no word is explained twice", () => {
  const terms = glossary.map(({ term }) => term);
  expect(new Set(terms).size).toBe(terms.length);
});

test("SWR-CON-023 the tour outlines one thing after the other, and leaves nothing behind", async () => {
  Element.prototype.scrollIntoView = () => undefined;
  const [first, second] = stops;
  render(
    <>
      <div className="banner">
        <p className="sign" />
        <p className="banner-text" />
      </div>
      <Help />
    </>,
  );
  press("?");
  await findSheet();
  fireEvent.click(screen.getByRole("button", { name: "Show me the page" }));
  await screen.findByText(new RegExp(`^1 of .*${first?.title.slice(0, 7)}`));
  const toured = () => document.querySelector("[data-toured]")?.className;
  expect(toured()).toBe("sign");
  fireEvent.click(screen.getByRole("button", { name: "Next" }));
  await screen.findByText(new RegExp(`^2 of .*${second?.title.slice(0, 3)}`));
  expect(toured()).toBe("banner-text");
  fireEvent.click(screen.getByRole("button", { name: "Skip the rest" }));
  expect(toured()).toBeUndefined();
});
