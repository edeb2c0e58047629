// SPDX-License-Identifier: Apache-2.0
// Rule under test: each channel of a force sensor is shown with what speaks against it, and its zeroing is commanded there; a
// robot without one shows nothing of it.
import {
  cleanup,
  fireEvent,
  render,
  screen,
  within,
} from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import { makeCommander, makeOutlook } from "../../testing/commander";
import { makeForce, makeRobot, makeViewProperties } from "../../testing/robot";
import { StatusView } from "../../views/StatusView";

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

const LABEL = "Zero the force sensor";

async function show(
  status: Parameters<typeof makeRobot>[0],
  ...allowed: string[]
) {
  const commander = await makeCommander("OPERATOR");
  const { authority, operation } = commander;
  render(
    <StatusView
      {...makeViewProperties(operation, makeRobot({ authority, ...status }))}
      outlook={makeOutlook(...allowed)}
    />,
  );
  await screen.findByText("a78c5496");
  return commander;
}

function rows(): string[] {
  const table = screen.getByRole("region", {
    name: "Channels of the force sensor",
  });
  return within(table)
    .getAllByRole("row")
    .slice(1)
    .map((row) => row.textContent);
}

test("SWR-FORCE-578 force, reading, zero and noise of each channel are shown, and why it is not to be believed", async () => {
  await show({
    forces: [
      makeForce({ force_mn: 1234, reading: 2110, zero_mn: -88, noise_mn: 31 }),
      makeForce({
        channel: "NEEDLE",
        force_mn: -500,
        reading: 1836,
        is_zeroing: true,
        doubts: [
          { name: "NOT_ZEROED", text: "Its zero was not taken." },
          { name: "STALE", text: "No report of it comes." },
        ],
      }),
    ],
  });
  expect(rows()).toEqual([
    "hand1.23 N2110−0.09 N0.031 Nnothing",
    "needle−0.50 N18360.00 N0.012 NIt is being zeroed. Its zero was not taken. No report of it comes.",
  ]);
});

test("SWR-FORCE-578 a robot without a force sensor shows nothing of it", async () => {
  await show({ forces: [] });
  expect(screen.queryByRole("heading", { name: "Forces" })).toBeNull();
  expect(screen.queryByRole("button", { name: LABEL })).toBeNull();
});

test("SWR-FORCE-578 zeroing is commanded where the server allows it", async () => {
  const { acts } = await show({ forces: [makeForce()] }, "ZERO_FORCE");
  fireEvent.click(screen.getByRole("button", { name: LABEL }));
  expect(acts()).toEqual([{ path: "/api/v1/force/zero", body: { id: 1 } }]);
});

test("SWR-FORCE-578 zeroing that the server would refuse cannot be pressed", async () => {
  await show({ forces: [makeForce()] });
  const button = screen.getByRole<HTMLButtonElement>("button", { name: LABEL });
  expect(button.disabled).toBe(true);
});
