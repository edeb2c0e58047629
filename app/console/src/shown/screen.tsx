// SPDX-License-Identifier: Apache-2.0
// The whole page before a robot of build/site/served.wasm, in the robot's time, and what stands on it by the names of shown.yml.
import { act, cleanup, fireEvent, render } from "@testing-library/react";
import { vi } from "vitest";
import type { RobotState } from "@interface";
import { App } from "../App";
import { TelemetryStore } from "../state/store";
import { FakeSurroundings } from "../testing/surroundings";
import { PAGE_NUMBER, type Act, type Play } from "./play";

/** Other values from a server: a field and its value. */
export type Said = Record<string, unknown>;
export type PageAct =
  Act | { say: Said } | { silence: true } | { click: string };

const PART_MS = 500;

function change(state: RobotState, said: Said): void {
  for (const [place, value] of Object.entries(said)) {
    const names = place.split(".");
    const last = names.pop() ?? "";
    const holder = names.reduce<unknown>(
      (found, name) => (found as Said)[name],
      state,
    );
    (holder as Said)[last] = value;
  }
}

function textOf(element: Element | null): string {
  return element?.textContent ?? "";
}

/** Text, and what pictures and buttons show besides. */
function looksOf(element: Element): string {
  return element.innerHTML;
}

export class Screen {
  private readonly play: Play;
  private readonly surroundings = new FakeSurroundings();
  private readonly store = new TelemetryStore(this.surroundings);
  private said: Said = {};
  private isSilent = false;

  constructor(play: Play) {
    this.play = play;
  }

  static prepare(): void {
    vi.useFakeTimers({
      toFake: [
        "setInterval",
        "clearInterval",
        "setTimeout",
        "clearTimeout",
        "Date",
        "performance",
      ],
    });
    vi.spyOn(crypto, "getRandomValues").mockImplementation((array) => {
      (array as Uint32Array)[0] = PAGE_NUMBER;
      return array;
    });
  }

  async open(view: string): Promise<void> {
    window.location.hash = view;
    vi.stubGlobal("fetch", (address: string, options: RequestInit) =>
      this.isSilent
        ? Promise.reject(new Error("silence"))
        : Promise.resolve(this.play.fetch(address, options)),
    );
    this.store.start();
    render(<App store={this.store} />);
    await this.pass(PART_MS);
    await act(() => vi.dynamicImportSettled());
    await this.pass(3 * PART_MS);
  }

  close(): void {
    this.store.stop();
    cleanup();
  }

  async do(one: PageAct): Promise<void> {
    if ("say" in one) {
      this.said = one.say;
    } else if ("silence" in one) {
      this.isSilent = true;
    } else if ("click" in one) {
      const button = [...document.querySelectorAll("button")].find(
        (found) => found.textContent === one.click,
      );
      await act(async () => {
        fireEvent.click(button ?? document.body);
        await vi.advanceTimersByTimeAsync(0);
      });
    } else if ("wait" in one) {
      await this.pass(one.wait);
    } else {
      const refusal = this.play.do(one);
      if (refusal !== null) {
        throw new Error(`${JSON.stringify(one)}: ${refusal}`);
      }
    }
  }

  /** Lets so much time pass, of the robot and of the page. */
  async pass(ms: number): Promise<void> {
    for (let left = ms; left > 0; left -= PART_MS) {
      this.play.step(PART_MS);
      this.surroundings.pass(PART_MS);
      const news = this.play.listen();
      const last = news.findLast(({ type }) => type === "state");
      await act(async () => {
        if (!this.isSilent) {
          news
            .filter((one) => one.type !== "state" || one === last)
            .forEach(({ type, data }) => this.hear(type, data));
        }
        await vi.advanceTimersByTimeAsync(PART_MS);
      });
    }
  }

  private hear(type: string, data: string): void {
    const read = JSON.parse(data) as RobotState;
    if (type === "state") {
      change(read, this.said);
    }
    this.surroundings.stream.send(type as "state", read);
  }

  /** Texts on it, by name. */
  read(): Map<string, string> {
    const found = new Map<string, string>([["title", document.title]]);
    const add = (name: string, text: string) =>
      found.set(name, (found.get(name) ?? "") + text);
    for (const lamp of document.querySelectorAll<HTMLElement>(".lamps .lamp")) {
      const label = textOf(lamp.querySelector(".lamp-label"));
      add(`lamp ${label}`, `${lamp.dataset.level} ${lamp.textContent}`);
    }
    for (const part of document.querySelectorAll(".banner [class]")) {
      for (const name of part.classList) {
        add(`banner ${name}`, looksOf(part));
      }
    }
    for (const part of document.querySelectorAll(".toolbar > *")) {
      const name = part.getAttribute("aria-label") ?? part.className;
      add(`toolbar ${name}`, textOf(part));
    }
    add("footer", textOf(document.querySelector("footer")));
    for (const panel of document.querySelectorAll(".panels .panel")) {
      this.readPanel(panel, add);
    }
    return found;
  }

  private readPanel(
    panel: Element,
    add: (name: string, text: string) => void,
  ): void {
    const title = textOf(panel.querySelector("h2"));
    add(title, looksOf(panel));
    for (const term of panel.querySelectorAll("dt")) {
      add(`${title} / ${textOf(term)}`, textOf(term.nextElementSibling));
    }
    for (const table of panel.querySelectorAll("table")) {
      const columns = [...table.querySelectorAll("thead th")].map(
        (column) => column.firstChild?.textContent ?? "",
      );
      for (const row of table.querySelectorAll("tbody tr")) {
        [...row.children].forEach((cell, at) =>
          add(`${title} / ${columns[at]}`, looksOf(cell)),
        );
      }
    }
  }
}
