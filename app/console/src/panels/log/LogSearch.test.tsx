// SPDX-License-Identifier: Apache-2.0
// Rule under test: events that were asked for in vain are asked for again until they are there.
import { act, cleanup, render, screen } from "@testing-library/react";
import { afterEach, test, vi } from "vitest";
import { Page } from "../../state/page";
import { makeEntry } from "../../testing/robot";
import { AGAIN_AFTER_MS, LogSearch } from "./LogSearch";

afterEach(() => {
  cleanup();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("SWR-CON-060 the log is asked for again until it is there", async () => {
  vi.useFakeTimers();
  let lost = 3;
  const entry = makeEntry(0);
  const log = { entries: [entry], next: 1, lost: 0 };
  vi.stubGlobal("fetch", () =>
    lost-- > 0
      ? Promise.reject(new Error("lost"))
      : Promise.resolve(new Response(JSON.stringify(log))),
  );
  render(<LogSearch page={new Page(() => null)} newest={undefined} />);
  await act(() => vi.advanceTimersByTimeAsync(4 * AGAIN_AFTER_MS));
  screen.getByText(entry.text);
});
