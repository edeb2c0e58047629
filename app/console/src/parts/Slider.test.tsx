// SPDX-License-Identifier: Apache-2.0
// Rule under test: a slider asks for nothing before it is let go, and for nothing at all while it is locked.
import { cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { makeAxis } from "../testing/robot";
import { Slider, type SliderProperties } from "./Slider";

const WIDTH = 400;
const sent = vi.fn();
/** From 0 to 40 mm, set-point 12.5: 10 pixels are 1 mm. */
const axis = makeAxis("head");

function slider(change: Partial<SliderProperties> = {}) {
  return (
    <Slider
      axis={axis}
      asked={null}
      step={5}
      isLocked={false}
      onSend={sent}
      {...change}
    />
  );
}

function frame(): HTMLElement {
  return screen.getByRole("slider", { name: "Set-point of head" });
}

function grip(): Element {
  const found = document.querySelector(".slider-grip");
  if (found === null) {
    throw new Error("nothing to take");
  }
  return found;
}

function said(): string | null {
  return frame().getAttribute("aria-valuetext");
}

function drag(pixels: number): void {
  fireEvent.pointerDown(grip(), { button: 0, clientX: 125, pointerId: 1 });
  fireEvent.pointerMove(grip(), { clientX: 125 + pixels, pointerId: 1 });
}

beforeEach(() => {
  sent.mockClear();
  Element.prototype.setPointerCapture = vi.fn();
  vi.spyOn(Element.prototype, "getBoundingClientRect").mockReturnValue(
    new DOMRect(0, 0, WIDTH, 20),
  );
});

afterEach(() => {
  cleanup();
  vi.restoreAllMocks();
});

test("SWR-CON-025 a drag asks for where it is let go, and for nothing on the way", () => {
  render(slider());
  drag(50);
  fireEvent.pointerMove(grip(), { clientX: 225, pointerId: 1 });
  expect(said()).toBe("22.50 mm, not sent, position 10.00 mm");
  expect(sent).not.toHaveBeenCalled();
  fireEvent.pointerUp(grip(), { clientX: 225, pointerId: 1 });
  expect(sent.mock.calls).toEqual([[22.5]]);
  expect(said()).toBe("12.50 mm, position 10.00 mm");
});

test("SWR-CON-025 a drag ends at the limits", () => {
  render(slider());
  drag(9999);
  fireEvent.pointerUp(grip(), { pointerId: 1 });
  expect(sent.mock.calls).toEqual([[40]]);
});

test("SWR-CON-025 a press beside the circle, or one that moves nothing, asks for nothing", () => {
  render(slider());
  fireEvent.pointerDown(frame(), { button: 0, clientX: 300, pointerId: 1 });
  fireEvent.pointerUp(frame(), { clientX: 300, pointerId: 1 });
  drag(0);
  fireEvent.pointerCancel(grip(), { pointerId: 1 });
  fireEvent.pointerDown(grip(), { button: 0, clientX: 125, pointerId: 1 });
  fireEvent.pointerUp(grip(), { clientX: 125, pointerId: 1 });
  expect(sent).not.toHaveBeenCalled();
});

test.each([
  ["ArrowRight", 1, 17.5],
  ["ArrowLeft", 2, 2.5],
  ["PageUp", 1, 40],
  ["PageDown", 1, 0],
])(
  "SWR-CON-025 %s held for %i repeats asks once, when it is let go",
  (key, repeats, end) => {
    render(slider());
    for (let repeat = 0; repeat < repeats; repeat += 1) {
      fireEvent.keyDown(frame(), { key });
    }
    expect(sent).not.toHaveBeenCalled();
    fireEvent.keyUp(frame(), { key });
    expect(sent.mock.calls).toEqual([[end]]);
  },
);

test("SWR-CON-025 leaving or stopping discards what was not sent", () => {
  render(slider());
  fireEvent.keyDown(frame(), { key: "ArrowRight" });
  fireEvent.blur(frame());
  fireEvent.keyUp(frame(), { key: "ArrowRight" });
  drag(50);
  fireEvent.keyDown(frame(), { key: "Escape" });
  fireEvent.pointerUp(grip(), { pointerId: 1 });
  expect(sent).not.toHaveBeenCalled();
});

test("SWR-CON-025 what is locked moves by nothing", () => {
  render(slider({ isLocked: true }));
  drag(50);
  fireEvent.pointerUp(grip(), { pointerId: 1 });
  fireEvent.keyDown(frame(), { key: "ArrowRight" });
  fireEvent.keyUp(frame(), { key: "ArrowRight" });
  expect(said()).toBe("12.50 mm, position 10.00 mm");
  expect(sent).not.toHaveBeenCalled();
});

test("SWR-CON-025 what is locked on the way is not sent, even when it is free again", () => {
  const { rerender } = render(slider());
  drag(50);
  rerender(slider({ isLocked: true }));
  rerender(slider());
  fireEvent.pointerMove(grip(), { clientX: 200, pointerId: 1 });
  fireEvent.pointerUp(grip(), { pointerId: 1 });
  expect(sent).not.toHaveBeenCalled();
});

test("SWR-CON-026 three marks: what is asked for, what control wants, where it is", () => {
  render(slider({ asked: 30 }));
  const at = (selector: string, name: string) =>
    document.querySelector(selector)?.getAttribute(name);
  expect(at("circle.track-setpoint", "cx")).toBe("75%");
  expect(at(".slider-accepted", "x1")).toBe("31.25%");
  expect(at(".track-position", "x")).toBe("25%");
});

test("SWR-CON-026 of a position that is not known no mark is shown", () => {
  render(slider({ axis: makeAxis("head", { reference: "fresh" }) }));
  expect(document.querySelectorAll("circle, .track-position")).toHaveLength(0);
  expect(said()).toBe("unknown");
});
