// SPDX-License-Identifier: Apache-2.0
// Rule under test: one file at a time is read beside the page, which says how far it is, and shows it or the reason why not.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { makeDocument } from "../testing/recording";
import type { ReaderPort, Report } from "./messages";
import { Recorded } from "./Recorded";
import { bytesOf } from "./recorded_file";

vi.mock("../panels/motors/Plots", () => ({ Plots: () => null }));
vi.mock("../panels/system/Charts", () => ({ SeenCharts: () => null }));

class FakeReader implements ReaderPort {
  onmessage: ReaderPort["onmessage"] = null;
  onerror: ReaderPort["onerror"] = null;
  postMessage = vi.fn();
  terminate = vi.fn();

  send(data: Report): void {
    act(() => this.onmessage?.({ data } as MessageEvent<Report>));
  }
}

let readers: FakeReader[];

beforeEach(() => {
  vi.stubGlobal("matchMedia", () => ({ matches: false }));
  readers = [];
  const newReader = () => {
    const reader = new FakeReader();
    readers.push(reader);
    return reader;
  };
  render(<Recorded newReader={newReader} packed="module" />);
});

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

function open(name: string): FakeReader {
  const file = new File([name], name);
  fireEvent.change(screen.getByLabelText("Open a recording"), {
    target: { files: [file] },
  });
  const reader = readers.at(-1)!;
  expect(reader.postMessage).toHaveBeenCalledExactlyOnceWith({
    packed: "module",
    file,
  });
  return reader;
}

function read(change: object = {}): Report {
  const text = JSON.stringify({ ...makeDocument(), ...change });
  return { kind: "read", document: new TextEncoder().encode(text) };
}

test("SWR-SITE-037 it says how far it is, and shows what was read", () => {
  const reader = open("one.bsr");
  const said = () => screen.getByText("one.bsr").parentElement?.textContent;
  expect(said()).toBe("Reading one.bsr, 0 %");
  reader.send({ kind: "share", share: 0.428 });
  expect(said()).toBe("Reading one.bsr, 42 %");
  expect(
    screen
      .getByRole("progressbar", { name: "Reading one.bsr" })
      .getAttribute("value"),
  ).toBe("0.428");
  reader.send(read());
  expect(said()).toBe("Shown is one.bsr.");
  expect(screen.getByRole("slider", { name: "Cycle" })).toBeTruthy();
});

test("SWR-SITE-037 another file ends the reading of the one before", () => {
  const first = open("one.bsr");
  const second = open("two.bsr");
  expect(first.terminate).toHaveBeenCalledOnce();
  second.send(read());
  expect(screen.getByText("two.bsr").parentElement?.textContent).toBe(
    "Shown is two.bsr.",
  );
});

test("SWR-SITE-036 of a file that is refused the reason is shown, and nothing of another one", () => {
  open("one.bsr").send(read());
  const reader = open("two.bsr");
  reader.send({ kind: "refused", reason: "Block 8 was changed." });
  expect(screen.getByRole("alert").textContent).toBe(
    "two.bsr is not shown. Block 8 was changed.",
  );
  expect(screen.queryByRole("slider")).toBeNull();
});

test("SWR-SITE-036 a reader that fails, and a recording of which nothing is known, are said", () => {
  const reader = open("one.bsr");
  act(() => reader.onerror?.(new ErrorEvent("error", { message: "No room." })));
  expect(screen.getByRole("alert").textContent).toContain("No room.");
  open("two.bsr").send(read({ rows: [[0], [100]] }));
  expect(screen.getByRole("alert").textContent).toContain(
    "no cycle of it is known",
  );
});

test("SWR-SITE-036 what cannot be shown is said, and so is what cannot be read", async () => {
  const document = new TextEncoder().encode("[");
  open("one.bsr").send({ kind: "read", document });
  expect(screen.getByRole("alert").textContent).toContain("JSON");
  const folder = new File([], "folder");
  folder.arrayBuffer = () => Promise.reject(new Error("at the time"));
  await expect(bytesOf(folder)).rejects.toThrow("it is a folder");
});

test("SWR-SITE-037 the direction of a name's letters is not that of what is said of it", () => {
  open("evil\u202Egnp.bsr").send(read());
  expect(screen.getByText("evil\u202Egnp.bsr").localName).toBe("bdi");
});

test("SWR-SITE-037 several files at once are refused, and what is dropped beside does not replace the page", () => {
  const [one, two] = [new File([], "1.bsr"), new File([], "2.bsr")];
  const place = screen.getByText("or drag it here");
  fireEvent.drop(place, { dataTransfer: { files: [one, two] } });
  expect(place.textContent).toBe(
    "None of the 2 files was taken: drag one here",
  );
  expect(readers).toEqual([]);
  const beside = { dataTransfer: { dropEffect: "copy" } };
  expect(fireEvent.dragOver(document.body, beside)).toBe(false);
  expect(fireEvent.drop(document.body, beside)).toBe(false);
  expect(readers).toEqual([]);
  open("1.bsr");
  expect(place.textContent).toBe("or drag it here");
});
