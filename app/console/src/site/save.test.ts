// SPDX-License-Identifier: Apache-2.0
// Rule under test: a link to a file of the server leads nowhere, and the file comes by the transport.
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { saveText } from "../words/download";
import { saveByTransport } from "./save";

vi.mock("../words/download", () => ({ saveText: vi.fn() }));

let answer: Response;
const request = vi.fn(() => Promise.resolve(answer));
const listener = saveByTransport({ request });

function click(link: string): boolean {
  document.body.innerHTML = link;
  return !document
    .querySelector("a")
    ?.dispatchEvent(
      new MouseEvent("click", { bubbles: true, cancelable: true }),
    );
}

beforeEach(() => {
  vi.clearAllMocks();
  document.addEventListener("click", listener);
});

afterEach(() => document.removeEventListener("click", listener));

test("SWR-SITE-011 a file of the server is saved by its own name or the one that the console gives it", async () => {
  const headers = { "Content-Type": "text/csv" };
  answer = new Response("a,b", { headers });
  expect(click('<a href="/api/v1/sweep/file.csv?a=1" download>x</a>')).toBe(
    true,
  );
  await vi.waitFor(() => expect(saveText).toHaveBeenCalledOnce());
  expect(saveText).toHaveBeenLastCalledWith("file.csv", "text/csv", "a,b");
  answer = new Response("c", { headers });
  click('<a href="/api/v1/log.csv" download="events.csv">x</a>');
  await vi.waitFor(() => expect(saveText).toHaveBeenCalledTimes(2));
  expect(saveText).toHaveBeenLastCalledWith("events.csv", "text/csv", "c");
});

test("SWR-SITE-011 what the server has not is not saved, and other links are left alone", async () => {
  answer = new Response("{}", { status: 404 });
  expect(click('<a href="/api/v1/log.csv" download>x</a>')).toBe(true);
  await Promise.resolve();
  expect(request).toHaveBeenCalledOnce();
  expect(click('<a href="#charts">x</a>')).toBe(false);
  expect(request).toHaveBeenCalledOnce();
  expect(saveText).not.toHaveBeenCalled();
});
