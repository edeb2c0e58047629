// SPDX-License-Identifier: Apache-2.0
// Rule under test: the panel says which entry point decides the depth and which is only proposed, and shows the needle
// that an image has shown.
import type { Targeting as TargetingData } from "@interface";
import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { makeRobot } from "../testing/robot";
import { Targeting } from "./Targeting";

afterEach(cleanup);

function show(change: Partial<TargetingData>) {
  const { targeting } = makeRobot();
  render(<Targeting targeting={{ ...targeting, ...change }} />);
}

function said(term: string): string | null | undefined {
  return screen.getByText(term).nextElementSibling?.textContent;
}

test("SWR-PLAN-023 a registration without its rotation is shown as such", () => {
  show({ registration: [1, 0, 0, 0], ignores_registration_rotation: true });
  expect(said("Registration")).toBe("accepted, its rotation ignored");
  cleanup();
  show({ registration: [1, 0, 0, 0], ignores_registration_rotation: false });
  expect(said("Registration")).toBe("accepted");
});

test("SWR-PROBE-009 the lengths of the probe are shown, or that they are not known", () => {
  show({});
  expect(said("Probe")).toBe("needle_tip 259.075 mm");
  cleanup();
  const [length] = makeRobot().targeting.probe;
  show({ probe: [{ ...length!, length_mm: null }] });
  expect(said("Probe")).toBe("needle_tip unknown");
});

test("SWR-PLAN-017 an entry point is shown with what it decides", () => {
  show({ entry_mm: [5, 246, 60] });
  expect(said("Entry point")).toBe("5.00, 246.00, 60.00 (decides the depth)");
  expect(said("Proposed entry point")).toBe("none");
});

test("SWR-PLAN-017 a proposed entry point is not shown as one that decides", () => {
  const { proposals } = makeRobot().targeting;
  show({ proposals: { ...proposals, entry_mm: [1, 2, 3] } });
  expect(said("Entry point")).toBe("none");
  expect(said("Proposed entry point")).toBe(
    "1.00, 2.00, 3.00 (decides nothing)",
  );
});

test("SWR-MOTION-024 the needle in the image is shown beside the target", () => {
  show({ seen_needle: null });
  expect(said("Needle seen in the image")).toBe("none");
  cleanup();
  show({ seen_needle: [1, 0, 0, 4, 0, 1, 0, 5, 0, 0, 1, 6, 0, 0, 0, 1] });
  expect(said("Needle seen in the image")).toBe("4.00, 5.00, 6.00");
  expect(said("Target")).toBe("none");
});
