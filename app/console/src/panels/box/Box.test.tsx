// SPDX-License-Identifier: Apache-2.0
// Rule under test: the drawer gives the simulated box the orders of a person there, and holds pedal and button as long as a
// user does who sees the page.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Box as BoxState, BoxSlot, Role } from "@interface";
import { KEEP_MS, LOOK_MS } from "../../state/box";
import { Operation } from "../../state/operation";
import { makeSession } from "../../testing/robot";
import { Box } from "./Box";

function makeSlot(slot: number, change: Partial<BoxSlot> = {}): BoxSlot {
  return {
    slot,
    axis: null,
    card_type: "none",
    card_fault: "normal",
    encoder_fault: "normal",
    motor_fault: "normal",
    switch_fault: "normal",
    ...change,
  };
}

let box: BoxState;
let asked: string[];
let refusals: Record<string, number>;
let operation: Operation;
let shown: ReturnType<typeof render>;

/** As the box does it. */
function obey(method: string, order: Record<string, unknown>): void {
  for (const handle of ["pedal", "button", "hand"] as const) {
    const isHeld = box[`${handle}_holder`] === operation.page.number;
    if (order[handle] === "hold") {
      box[`${handle}_holder`] = operation.page.number;
      box[`is_${handle}_pressed`] = true;
    } else if (isHeld && (order[handle] === "drop" || method === "DELETE")) {
      letGo(handle);
    }
  }
}

function letGo(handle: "pedal" | "button" | "hand"): void {
  box[`${handle}_holder`] = 0;
  box[`is_${handle}_pressed`] = false;
}

function answer(path: string, method: string, body: string): Response {
  if (path === "/api/v1/session") {
    return new Response(JSON.stringify(makeSession(role)));
  }
  if (method !== "GET") {
    asked.push(body === "" ? method : body);
  }
  const status = refusals[method] ?? 200;
  if (status === 0) {
    throw new TypeError("The network is gone.");
  }
  if (status !== 200) {
    return new Response(JSON.stringify({ detail: "It is refused." }), {
      status,
    });
  }
  obey(method, JSON.parse(body === "" ? "{}" : body) as object as never);
  return new Response(JSON.stringify(box));
}

let role: Role;

async function show(as: Role = "OPERATOR"): Promise<void> {
  role = as;
  vi.stubGlobal("fetch", (path: string, options: RequestInit) =>
    Promise.resolve(
      answer(path, options.method ?? "GET", (options.body ?? "") as string),
    ),
  );
  operation = new Operation();
  operation.session.start();
  shown = render(
    <Box name="mine-box" operation={operation} freshness="live" />,
  );
  fireEvent.click(button("Open the simulated box"));
  await pass(0);
}

/** Lets time pass, and what was asked be answered. */
async function pass(ms: number): Promise<void> {
  await act(() => vi.advanceTimersByTimeAsync(ms));
}

/** By the name that a screen reader says; the queries for roles take long among so many. */
function button(name: string): HTMLButtonElement {
  const found = [...document.querySelectorAll("button")].find(
    (one) => (one.ariaLabel ?? one.textContent) === name,
  );
  if (found === undefined) {
    throw new Error(`There is no button "${name}".`);
  }
  return found;
}

function pedalState(): string | null | undefined {
  return document.querySelector('[aria-label="Pedal"] strong')?.textContent;
}

const pointer = { button: 0, pointerId: 1 };

async function holdPedal(): Promise<void> {
  fireEvent.pointerDown(button("Hold pedal"), pointer);
  await pass(0);
}

function expectLetGo(by: string): void {
  expect(asked.at(-1)).toBe(by);
  expect(box.is_pedal_pressed).toBe(false);
  asked = [];
}

const hold = '{"pedal":"hold"}';
const drop = '{"pedal":"drop"}';

beforeEach(() => {
  vi.useFakeTimers();
  Element.prototype.setPointerCapture = () => undefined;
  box = {
    name: "mine-box",
    is_pedal_pressed: false,
    pedal_holder: 0,
    is_button_pressed: false,
    button_holder: 0,
    is_hand_pressed: false,
    hand_holder: 0,
    grip_mn: 3000,
    layers: 2,
    force_hand: "normal",
    force_needle: "normal",
    is_estop_pulled: false,
    is_scanner_active: false,
    is_lamp_alive: true,
    is_lamp_may_move: false,
    is_lamp_moving: false,
    is_lamp_fault: false,
    gate: "off",
    probe: "coupled",
    needle: null,
    slots: [
      makeSlot(0),
      makeSlot(1, { axis: "yaw", card_type: "pwm" }),
      makeSlot(2, { card_type: "sensor" }),
    ],
  };
  asked = [];
  refusals = {};
});

afterEach(() => {
  operation.session.stop();
  cleanup();
  vi.useRealTimers();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

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
  role = "OBSERVER";
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
    refusals = { PUT: status };
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
  refusals = { POST: 503 };
  fireEvent.pointerDown(button("Hold pedal"), pointer);
  box.pedal_holder = operation.page.number;
  box.is_pedal_pressed = true;
  await pass(0);
  refusals = {};
  fireEvent.pointerUp(button("Hold pedal"), pointer);
  await pass(3 * KEEP_MS);
  expect(asked).not.toContain("PUT");
});

test("SWR-CON-041 a pedal whose release was lost is not renewed with the button", async () => {
  await show();
  fireEvent.click(button("Keep button pressed"));
  await pass(0);
  await holdPedal();
  refusals = { POST: 0 };
  fireEvent.pointerUp(button("Hold pedal"), pointer);
  await pass(0);
  expect(box.is_pedal_pressed).toBe(true);
  refusals = {};
  await pass(KEEP_MS);
  expect(box.is_pedal_pressed).toBe(false);
  expect(box.is_button_pressed).toBe(true);
});

test("SWR-CON-039 an answer that is no box is not shown as one", async () => {
  box = {} as BoxState;
  await show();
  screen.getByText("The simulated box has not answered.");
});

test("SWR-CON-040 what another page holds is reported", async () => {
  await show();
  refusals = { POST: 409 };
  await holdPedal();
  expect(screen.getByRole("alert").textContent).toBe("It is refused.");
  refusals = {};
  box.pedal_holder = operation.page.number + 1;
  box.is_pedal_pressed = true;
  await pass(LOOK_MS);
  expect(pedalState()).toBe("held by another page");
  expect(asked).toEqual([hold]);
});

test.each([
  ["Pull e-stop", '{"estop":"pull"}'],
  ["Scanner on", '{"scanner":"on"}'],
  ["Free probe", '{"probe":"free"}'],
  ["Push 10 mm out", '{"push_mm":-10}'],
])("SWR-CON-040 %s is one order", async (name, order) => {
  await show();
  fireEvent.click(button(name));
  expect(asked).toEqual([order]);
});

function choose(name: string, value: string): void {
  const label = [...document.querySelectorAll("label")].find(
    (one) => one.querySelector(".box-name")?.textContent === name,
  );
  fireEvent.change(label?.querySelector("select") as Element, {
    target: { value },
  });
}

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

test("SWR-BOX-534 grip, tissue and faults of load cells are orders", async () => {
  await show();
  choose("Hand", "5000");
  choose("Load cell of the hand", "stuck");
  choose("Load cell of the needle", "drift");
  fireEvent.click(button("Make tissue whole"));
  fireEvent.click(button("Take tissue away"));
  expect(asked).toEqual([
    '{"grip_mn":5000}',
    '{"force_hand":"stuck"}',
    '{"force_needle":"drift"}',
    '{"tissue":"whole"}',
    '{"tissue":"none"}',
  ]);
});

test("SWR-BOX-534 the box is shown as it is", async () => {
  box.grip_mn = -1234;
  box.layers = 0;
  box.force_needle = "full";
  await show();
  expect(
    document.querySelector('[aria-label="Hand"] select')?.textContent,
  ).toContain("pulls with 1.234 N");
  expect(
    document.querySelector('[aria-label="Tissue"] strong')?.textContent,
  ).toBe("none");
  fireEvent.click(button("Put tissue there"));
  expect(asked).toEqual(['{"tissue":"usual"}']);
  expect(
    document.querySelector<HTMLSelectElement>(
      '[aria-label="Load cell of the needle"] select',
    )?.value,
  ).toBe("full");
});

test("SWR-BOX-778 the needle is shown where the box shows one", async () => {
  await show();
  expect(document.querySelector(".box-needle")).toBeNull();
  box.needle = {
    surface_mm: 30,
    turn_deg: 0,
    lag_deg: 0,
    way: [{ x_mm: 0, y_mm: 0, depth_mm: 2 }],
    target: null,
    image: null,
    curvature: 4100,
    torsion_deg: 45,
    images_period_ms: 2000,
    images_delay_ms: 500,
    images_noise_um: 500,
  };
  await pass(LOOK_MS);
  expect(document.querySelector(".box-needle")).not.toBeNull();
  fireEvent.click(button("Put a moving target there"));
  expect(asked).toEqual(['{"target":"usual"}']);
});

test("SWR-BOX-534 a box without a sensor card has neither handle nor tissue", async () => {
  box.slots = box.slots.filter(({ card_type }) => card_type !== "sensor");
  await show();
  expect(document.querySelector('[aria-label="Handle"]')).toBeNull();
  expect(document.querySelector('[aria-label="Tissue"]')).toBeNull();
});

test("SWR-CON-040 the button shows what is at the box, and the other way", async () => {
  box.is_estop_pulled = true;
  box.is_scanner_active = true;
  await show();
  fireEvent.click(button("Reset e-stop"));
  fireEvent.click(button("Scanner off"));
  fireEvent.click(button("Reach dose"));
  expect(asked).toEqual([
    '{"estop":"reset"}',
    '{"scanner":"off"}',
    '{"gate":"dose"}',
  ]);
});

test("SWR-CON-040 the lamps that are lit are named", async () => {
  const lamps = () =>
    document.querySelector('[aria-label="Lamps"] strong')?.textContent;
  await show();
  expect(lamps()).toBe("alive");
  box.is_lamp_may_move = true;
  box.is_lamp_moving = true;
  await pass(LOOK_MS);
  expect(lamps()).toBe("alive, may move, moving");
  box.is_lamp_alive = box.is_lamp_may_move = box.is_lamp_moving = false;
  box.is_lamp_fault = true;
  await pass(LOOK_MS);
  expect(lamps()).toBe("fault");
  box.is_lamp_fault = false;
  await pass(LOOK_MS);
  expect(lamps()).toBe("dark");
});

test("SWR-CON-040 a fault is caused, seen and mended", async () => {
  await show();
  fireEvent.change(screen.getByLabelText("Fault"), {
    target: { value: "card_fault silent" },
  });
  fireEvent.click(button("Do it"));
  expect(asked).toEqual(['{"slot":1,"card_fault":"silent"}']);
  box.slots[1] = makeSlot(1, { ...box.slots[1], card_fault: "silent" });
  await pass(LOOK_MS);
  screen.getByText(/1 yaw: card does not answer/);
  fireEvent.click(button("Mend 1 yaw: card"));
  expect(asked.at(-1)).toBe('{"slot":1,"card_fault":"normal"}');
});

test("SWR-CON-040 where no axis is, a card is put in, and nothing else fails", async () => {
  await show();
  fireEvent.change(screen.getByLabelText("Slot"), { target: { value: "2" } });
  const values = screen
    .getAllByRole<HTMLOptionElement>("option")
    .map((option) => option.value);
  expect(values).toContain("card_fault corrupt");
  expect(values).not.toContain("motor_fault stuck");
  fireEvent.change(screen.getByLabelText("Fault"), {
    target: { value: "plug analog" },
  });
  fireEvent.click(button("Do it"));
  expect(asked).toEqual(['{"slot":2,"plug":"analog"}']);
});

test("SWR-CON-040 an observer sees and works nothing", async () => {
  await show("OBSERVER");
  screen.getByText("Log in as operator to command.");
  const enabled = screen
    .getAllByRole<HTMLButtonElement>("button")
    .filter(({ disabled }) => !disabled);
  expect(enabled.map(({ textContent }) => textContent)).toEqual([
    "Close the simulated box",
  ]);
});
