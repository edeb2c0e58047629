// SPDX-License-Identifier: Apache-2.0
// Rule under test: pedal, button and handle of the simulated box are held as long as a user holds them who sees the page.
import { act, fireEvent, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { KEEP_MS, LOOK_MS } from "../../state/box";
import {
  asked,
  beginBox,
  box,
  button,
  changeRole,
  drop,
  endBox,
  expectLetGo,
  hold,
  holdPedal,
  letGo,
  operation,
  pass,
  pedalState,
  pointer,
  refuse,
  show,
  shown,
} from "../../testing/box";
import { Box } from "./Box";

beforeEach(beginBox);
afterEach(endBox);

test("SWR-CON-040 the pedal is pressed as long as the pointer is down, and renewed", async () => {
  await show();
  await holdPedal();
  expect(pedalState()).toBe("held by this page");
  await pass(2 * KEEP_MS);
  expect(asked).toEqual([hold, "PUT", "PUT"]);
  fireEvent.pointerUp(button("Hold pedal"), pointer);
  await pass(0);
  expectLetGo(drop);
  await pass(3 * KEEP_MS);
  expect(asked).toEqual([]);
  expect(pedalState()).toBe("released");
});

test.each([" ", "Enter"])(
  "SWR-CON-040 the key %j holds it, and its repetition is no press",
  async (key) => {
    await show();
    for (let repeat = 0; repeat < 20; repeat += 1) {
      fireEvent.keyDown(button("Hold pedal"), { key, repeat: repeat > 0 });
    }
    await pass(0);
    expect(asked).toEqual([hold]);
    fireEvent.keyUp(button("Hold pedal"), { key });
    await pass(0);
    expectLetGo(drop);
  },
);

test("SWR-CON-040 it can be kept pressed, and is let go by the same switch", async () => {
  await show();
  const latch = screen.getByRole("switch", { name: "Keep pedal pressed" });
  fireEvent.click(latch);
  await pass(KEEP_MS);
  expect(asked).toEqual([hold, "PUT"]);
  fireEvent.pointerDown(button("Hold pedal"), pointer);
  fireEvent.pointerUp(button("Hold pedal"), pointer);
  expect(box.is_pedal_pressed).toBe(true);
  expect(latch.getAttribute("aria-checked")).toBe("true");
  fireEvent.click(latch);
  await pass(0);
  expectLetGo(drop);
});

test.each<[string, string, () => void]>([
  [
    "the pointer is taken away",
    drop,
    () => fireEvent.pointerCancel(button("Hold pedal"), pointer),
  ],
  [
    "the capture is lost",
    drop,
    () => fireEvent.lostPointerCapture(button("Hold pedal"), pointer),
  ],
  [
    "the button loses the focus",
    drop,
    () => fireEvent.blur(button("Hold pedal")),
  ],
  ["another window is typed into", "DELETE", () => fireEvent.blur(window)],
  [
    "the page is left",
    "DELETE",
    () => fireEvent(window, new Event("pagehide")),
  ],
  [
    "the page is hidden",
    "DELETE",
    () => {
      vi.spyOn(document, "visibilityState", "get").mockReturnValue("hidden");
      fireEvent(document, new Event("visibilitychange"));
    },
  ],
  [
    "the drawer is closed",
    "DELETE",
    () => fireEvent.click(button("Close the simulated box")),
  ],
  ["the panel is gone", "DELETE", () => shown.unmount()],
  [
    "the data is stale",
    "DELETE",
    () =>
      shown.rerender(
        <Box name="mine-box" operation={operation} freshness="stale" />,
      ),
  ],
])("SWR-CON-041 it is let go when %s", async (_, by, happen) => {
  await show();
  await holdPedal();
  happen();
  await pass(0);
  expectLetGo(by);
  await pass(3 * KEEP_MS);
  expect(asked).toEqual([]);
});

test("SWR-CON-041 it is let go when the session ends", async () => {
  await show();
  await holdPedal();
  changeRole("OBSERVER");
  await act(() => operation.session.renew());
  await pass(0);
  expectLetGo("DELETE");
});

test.each([
  ["is refused", 503, "It is refused."],
  ["is not answered", 0, "The server does not answer."],
])(
  "SWR-CON-041 it is let go when a renewal %s, and nothing is renewed then",
  async (_, status, reason) => {
    await show();
    await holdPedal();
    refuse({ PUT: status });
    await pass(KEEP_MS);
    expectLetGo("DELETE");
    expect(screen.getByRole("alert").textContent).toBe(reason);
    await pass(3 * KEEP_MS);
    expect(asked).toEqual([]);
  },
);

test("SWR-CON-041 what was let go at the box is not held again by itself", async () => {
  await show();
  await holdPedal();
  letGo("pedal");
  await pass(KEEP_MS);
  expect(screen.getByRole("alert").textContent).toContain("let go at the box");
  await pass(3 * KEEP_MS);
  expect(asked).toEqual([hold, "PUT"]);
  expect(pedalState()).toBe("released");
});

test("SWR-CON-041 who lets go before the answer comes does not hold what he gets", async () => {
  await show();
  fireEvent.pointerDown(button("Hold pedal"), pointer);
  fireEvent.pointerUp(button("Hold pedal"), pointer);
  await pass(3 * KEEP_MS);
  expect(asked).toEqual([hold, drop, drop]);
  expect(box.is_pedal_pressed).toBe(false);
});

test.each<[string, (down: boolean) => void]>([
  [
    "finger",
    (isDown) => {
      const second = { button: 0, pointerId: 2 };
      const of = button("Hold pedal");
      return isDown
        ? fireEvent.pointerDown(of, second)
        : fireEvent.pointerUp(of, second);
    },
  ],
  [
    "key",
    (isDown) => {
      const of = button("Hold pedal");
      return isDown
        ? fireEvent.keyDown(of, { key: " " })
        : fireEvent.keyUp(of, { key: " " });
    },
  ],
])(
  "SWR-CON-041 it is let go when another %s was down on it as well",
  async (_, press) => {
    await show();
    await holdPedal();
    press(true);
    await pass(KEEP_MS);
    fireEvent.pointerUp(button("Hold pedal"), pointer);
    press(false);
    await pass(0);
    expectLetGo(drop);
    await pass(3 * KEEP_MS);
    expect(asked).toEqual([]);
  },
);

test("SWR-CON-041 nothing is held for a press that is refused after one that was not", async () => {
  await show();
  fireEvent.pointerDown(button("Hold pedal"), pointer);
  fireEvent.pointerUp(button("Hold pedal"), pointer);
  refuse({ POST: 503 });
  fireEvent.pointerDown(button("Hold pedal"), pointer);
  box.pedal_holder = operation.page.number;
  box.is_pedal_pressed = true;
  await pass(0);
  refuse({});
  fireEvent.pointerUp(button("Hold pedal"), pointer);
  await pass(3 * KEEP_MS);
  expect(asked).not.toContain("PUT");
});

test("SWR-CON-041 a pedal whose release was lost is not renewed with the button", async () => {
  await show();
  fireEvent.click(button("Keep button pressed"));
  await pass(0);
  await holdPedal();
  refuse({ POST: 0 });
  fireEvent.pointerUp(button("Hold pedal"), pointer);
  await pass(0);
  expect(box.is_pedal_pressed).toBe(true);
  refuse({});
  await pass(KEEP_MS);
  expect(box.is_pedal_pressed).toBe(false);
  expect(box.is_button_pressed).toBe(true);
});

test("SWR-CON-040 what another page holds is reported", async () => {
  await show();
  refuse({ POST: 409 });
  await holdPedal();
  expect(screen.getByRole("alert").textContent).toBe("It is refused.");
  refuse({});
  box.pedal_holder = operation.page.number + 1;
  box.is_pedal_pressed = true;
  await pass(LOOK_MS);
  expect(pedalState()).toBe("held by another page");
  expect(asked).toEqual([hold]);
});

test("SWR-BOX-534 the handle is pressed as long as the pointer is down", async () => {
  await show();
  fireEvent.pointerDown(button("Hold handle"), pointer);
  await pass(KEEP_MS);
  expect(box.is_hand_pressed).toBe(true);
  fireEvent.pointerUp(button("Hold handle"), pointer);
  await pass(0);
  expect(asked).toEqual(['{"hand":"hold"}', "PUT", '{"hand":"drop"}']);
  expect(box.is_hand_pressed).toBe(false);
});
