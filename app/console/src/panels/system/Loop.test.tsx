// SPDX-License-Identifier: Apache-2.0
// Rule under test: the panel says how time passes, and shows no punctuality where nothing can be late.
import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { makeStatus } from "../../testing/robot";
import { Loop } from "./Loop";

afterEach(cleanup);

test("SWR-SUP-005 elastic time is named with its speed", () => {
  const time = {
    is_elastic: true,
    slowness: 1,
    speedup: 1,
    speed_percent: 41.26,
  };
  render(<Loop status={makeStatus({ time })} />);
  expect(screen.getByText("elastic, 41.3 % speed")).toBeTruthy();
  expect(screen.queryByText(/Wake-up/)).toBeNull();
});

test("SWR-BOX-044 fast time is named with its speed", () => {
  const time = {
    is_elastic: true,
    slowness: 1,
    speedup: 10,
    speed_percent: 850,
  };
  render(<Loop status={makeStatus({ time })} />);
  expect(screen.getByText("fast, 850.0 % speed")).toBeTruthy();
});

test("SWR-SUP-005 real time is named with its speed and its punctuality", () => {
  const time = {
    is_elastic: false,
    slowness: 5,
    speedup: 1,
    speed_percent: 20,
  };
  render(<Loop status={makeStatus({ time })} />);
  expect(screen.getByText("real, 20.0 % speed")).toBeTruthy();
  expect(screen.getByText(/Wake-up, 99 %/)).toBeTruthy();
});

test("SWR-CON-036 what the computer lacks is reported with what to do", () => {
  const { loop } = makeStatus();
  const text = "The kernel is not PREEMPT_RT: boot the real-time kernel.";
  const computer = [{ name: "KERNEL" as const, text }];
  const { rerender } = render(<Loop status={makeStatus()} />);
  expect(screen.getByText("fit for real time")).toBeTruthy();
  rerender(<Loop status={makeStatus({ loop: { ...loop, computer } })} />);
  expect(screen.queryByText("fit for real time")).toBeNull();
  expect(screen.getByRole("listitem").textContent).toBe(text);
});

test("SWR-CON-036 page faults are reported, and those that waited for the disk", () => {
  const { loop } = makeStatus();
  const faults = { minor_faults: 12, major_faults: 3 };
  render(<Loop status={makeStatus({ loop: { ...loop, ...faults } })} />);
  expect(screen.getByText("15 / 3")).toBeTruthy();
});
