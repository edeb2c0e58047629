// SPDX-License-Identifier: Apache-2.0
// Rule under test: the panel says which entry point decides the depth and which is only proposed, and shows the needle
// that an image has shown.
import type { Origin, Targeting as TargetingData } from "@interface";
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { makeRobot } from "../../testing/robot";
import { Targeting } from "./Targeting";

afterEach(cleanup);

function show(change: Partial<TargetingData>) {
  const { targeting } = makeRobot();
  render(<Targeting targeting={{ ...targeting, ...change }} />);
}

function said(term: string): string | null | undefined {
  return screen
    .getByText(term)
    .nextElementSibling?.textContent.replaceAll("\u00a0", " ");
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

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

function by(name: string, age_s: number): Origin {
  return { source: "IGTL", peer: 21, name, age_s };
}

test("SWR-IGTL-072 each proposal is shown with who made it and how old it is", () => {
  const { proposals } = makeRobot().targeting;
  show({
    proposals: {
      ...proposals,
      registration: IDENTITY,
      registration_by: by("crtk 10.0.0.7:40000", 300),
      entry_mm: [1, 2, 3],
      entry_by: by("crtk 10.0.0.8:40001", 12.4),
      target_mm: [4, 5, 6],
      target_by: by("connection 21", 0.3),
    },
  });
  expect(said("Proposed registration")).toBe(
    "at 0.00, 0.00, 0.00 (decides nothing), from crtk 10.0.0.7:40000, 5 min ago",
  );
  expect(said("Proposed entry point")).toBe(
    "1.00, 2.00, 3.00 (decides nothing), from crtk 10.0.0.8:40001, 12 s ago",
  );
  expect(said("Proposed target")).toBe(
    "4.00, 5.00, 6.00 (not reachable), from connection 21, under 1 s ago",
  );
});

test("SWR-IGTL-072 what counts is shown with who sent it and how old it is", () => {
  const anna: Origin = { ...by("page of anna", 62), source: "HTTP" };
  show({
    registration: IDENTITY,
    registration_by: anna,
    target: IDENTITY,
    target_by: anna,
    entry_mm: [5, 246, 60],
    entry_by: anna,
  });
  const from = ", from page of anna, 62 s ago";
  expect(said("Registration")).toBe(`accepted${from}`);
  expect(said("Target")).toBe(`0.00, 0.00, 0.00${from}`);
  expect(said("Entry point")).toBe(
    `5.00, 246.00, 60.00 (decides the depth)${from}`,
  );
});

test("SWR-CON-106 registration, pose and target are there as matrices, to be pasted elsewhere", () => {
  show({ registration: null, scanner_treatment: null, target: null });
  expect(screen.queryAllByRole("textbox")).toEqual([]);
  cleanup();
  const moved = [0, -1, 0, -5.25, 1, 0, 0, 6, 0, 0, 1, 7.5, 0, 0, 0, 1];
  show({ registration: IDENTITY, scanner_treatment: moved, target: IDENTITY });
  const value = (label: string) =>
    screen.getByLabelText<HTMLTextAreaElement>(label).value;
  const identity = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1";
  expect(value("Scanner from z-frame (registration)")).toBe(identity);
  expect(value("Scanner from target")).toBe(identity);
  expect(value("Scanner from needle (now)")).toBe(
    "0 -1 0 -5.25\n1 0 0 6\n0 0 1 7.5\n0 0 0 1",
  );
});

test("SWR-CON-106 a matrix is selected whole when it is clicked", () => {
  show({ registration: IDENTITY });
  const area = screen.getByLabelText<HTMLTextAreaElement>(
    "Scanner from z-frame (registration)",
  );
  fireEvent.focus(area);
  expect([area.selectionStart, area.selectionEnd]).toEqual([
    0,
    area.value.length,
  ]);
});

test("SWR-MOTION-024 the needle in the image is shown beside the target", () => {
  show({ seen_needle: null });
  expect(said("Needle seen in the image")).toBe("none");
  cleanup();
  show({ seen_needle: [1, 0, 0, 4, 0, 1, 0, 5, 0, 0, 1, 6, 0, 0, 0, 1] });
  expect(said("Needle seen in the image")).toBe("4.00, 5.00, 6.00");
  expect(said("Target")).toBe("none");
});
