// SPDX-License-Identifier: Apache-2.0
// Rule under test: the theme is the system's until another is chosen, and stays chosen; the clock goes in UTC.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import { Clock } from "./drawn/Clock";
import { applyKeptTheme, ThemeChoice } from "./ThemeChoice";

afterEach(() => {
  cleanup();
  vi.useRealTimers();
});

test("SWR-CON-022 the theme is the system's until one is chosen, and then kept", () => {
  localStorage.clear();
  applyKeptTheme();
  expect(document.documentElement.dataset.theme).toBe("system");
  render(<ThemeChoice />);
  fireEvent.change(screen.getByRole("combobox", { name: "Theme" }), {
    target: { value: "light" },
  });
  expect(document.documentElement.dataset.theme).toBe("light");
  delete document.documentElement.dataset.theme;
  applyKeptTheme();
  expect(document.documentElement.dataset.theme).toBe("light");
});

test("SWR-CON-022 what is kept and unknown is the system's theme", () => {
  localStorage.setItem("boresight-theme", "sepia");
  applyKeptTheme();
  expect(document.documentElement.dataset.theme).toBe("system");
});

test("SWR-CON-020 the clock shows UTC", async () => {
  vi.useFakeTimers({ now: new Date("2026-11-23T03:04:05Z") });
  const { container } = render(<Clock />);
  expect(container.textContent).toBe("03:04:05 UTC");
  await act(() => vi.advanceTimersByTimeAsync(2000));
  expect(container.textContent).toBe("03:04:07 UTC");
});
