// SPDX-License-Identifier: Apache-2.0
// Rule under test: the true needle of the simulated box is drawn from two sides, is named as simulated, and its choices are
// orders to the box.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { BoxNeedle as Needle, BoxPoint } from "@interface";
import type { BoxHands } from "../../state/box";
import { BoxNeedle } from "./BoxNeedle";

function point(x_mm: number, y_mm: number, depth_mm: number): BoxPoint {
  return { x_mm, y_mm, depth_mm };
}

const order = vi.fn();
const hands = { order } as unknown as BoxHands;
let needle: Needle;

function show(isDisabled = false): void {
  render(<BoxNeedle hands={hands} box={{ needle }} isDisabled={isDisabled} />);
}

function facts(): string[] {
  return [...document.querySelectorAll("dd")].map(
    (one) => one.textContent ?? "",
  );
}

function view(name: string): SVGElement {
  const found = document.querySelector<SVGElement>(
    `svg[aria-label="Simulated truth, ${name}"]`,
  );
  if (found === null) {
    throw new Error(`There is no view ${name}.`);
  }
  return found;
}

beforeEach(() => {
  order.mockClear();
  needle = {
    surface_mm: 30,
    turn_deg: 95,
    lag_deg: 31.5,
    way: [point(0, 0, 0), point(0, 0, 50), point(1.5, -9.98, 99)],
    target: null,
    image: null,
    curvature: 4100,
    torsion_deg: 45,
    images_period_ms: 2000,
    images_delay_ms: 500,
    images_noise_um: 500,
  };
});

afterEach(cleanup);

test("SWR-BOX-778 the shaft is drawn as it is bent, from the side and from above", () => {
  show();
  expect(
    screen.getByText("Needle in tissue: truth of the simulation"),
  ).toBeTruthy();
  const line = (name: string) =>
    view(name).querySelector("polyline")?.getAttribute("points");
  expect(line("from the side, y upwards")).toBe("0 0 50 0 99 9.98");
  expect(line("from above, x upwards")).toBe("0 0 50 0 99 -1.5");
  expect(facts()).toEqual([
    "x 1.50 mm, y −9.98 mm, depth 99.00 mm",
    "turned by 95.0 degrees, 31.5 ahead of the tip",
    "none",
    "none yet",
  ]);
  expect(document.querySelector("[data-mark]")).toBeNull();
});

test("SWR-BOX-778 target and image are drawn where they are, with distance and age", () => {
  needle.target = point(1.5, -5.98, 102);
  needle.image = { number: 12, age_ms: 740, place: point(2, -9, 98) };
  show();
  const at = (name: string, mark: string) =>
    view(name)
      .querySelector(`[data-mark="${mark}"]`)
      ?.getAttribute("transform");
  expect(at("from the side, y upwards", "target")).toBe("translate(102 5.98)");
  expect(at("from above, x upwards", "target")).toBe("translate(102 -1.5)");
  expect(at("from the side, y upwards", "image")).toBe("translate(98 9)");
  expect(at("from above, x upwards", "image")).toBe("translate(98 -2)");
  expect(facts()[2]).toContain("5.00 mm from the tip");
  expect(facts()[3]).toBe(
    "12, 0.7 s old, x 2.00 mm, y −9.00 mm, depth 98.00 mm",
  );
});

test("SWR-BOX-778 all that is drawn is within the views", () => {
  needle.target = point(-33, 0, 171);
  show();
  const [left, top, width, height] = (
    view("from above, x upwards").getAttribute("viewBox") ?? ""
  )
    .split(" ")
    .map(Number) as [number, number, number, number];
  expect(left).toBeLessThan(0);
  expect(left + width).toBeGreaterThan(171);
  expect(top + height).toBeGreaterThan(33);
});

test("SWR-BOX-778 curvature, torsion, images and a target are orders", () => {
  show();
  const choose = (name: string, value: string) =>
    fireEvent.change(
      document.querySelector(`[aria-label="${name}"] select`) as Element,
      { target: { value } },
    );
  choose("Curvature", "2200");
  choose("Torsion", "20");
  choose("Images", "0");
  choose("Delay of images", "200");
  choose("Noise of images", "300");
  fireEvent.click(screen.getByText("Put a moving target there"));
  expect(order.mock.calls.map(([one]) => one as unknown)).toEqual([
    { needle_curvature: 2200 },
    { needle_torsion: 20 },
    { images_period_ms: 0 },
    { images_delay_ms: 200 },
    { images_noise_um: 300 },
    { target: "usual" },
  ]);
  cleanup();
  needle.target = point(0, 0, 100);
  show();
  fireEvent.click(screen.getByText("Take target away"));
  expect(order).toHaveBeenLastCalledWith({ target: "none" });
});

test("SWR-BOX-778 a number of another source is shown beside those that can be chosen", () => {
  needle.curvature = 3333;
  show(true);
  const select = document.querySelector<HTMLSelectElement>(
    '[aria-label="Curvature"] select',
  );
  expect(select?.value).toBe("3333");
  expect(select?.textContent).toContain("0.003333 per mm");
  expect(select?.disabled).toBe(true);
});
