// SPDX-License-Identifier: Apache-2.0
// The drawer of the simulated box, before a box that obeys and writes down what it was ordered.
import { act, cleanup, fireEvent, render } from "@testing-library/react";
import { expect, vi } from "vitest";
import type { Box as BoxState, BoxSlot, Role } from "@interface";
import { Box } from "../panels/box/Box";
import { Operation } from "../state/operation";
import { makeSession } from "./robot";

export function makeSlot(slot: number, change: Partial<BoxSlot> = {}): BoxSlot {
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

/** The box as it is, and the orders that it was given. */
export let box: BoxState;
export let asked: string[];
export let operation: Operation;
export let shown: ReturnType<typeof render>;
let refusals: Record<string, number>;

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

export function letGo(handle: "pedal" | "button" | "hand"): void {
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

/** Status by method with which the box refuses; 0: it does not answer. */
export function refuse(statuses: Record<string, number>): void {
  refusals = statuses;
}

export function changeRole(to: Role): void {
  role = to;
}

export function answerWith(other: BoxState): void {
  box = other;
}

export async function show(as: Role = "OPERATOR"): Promise<void> {
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
export async function pass(ms: number): Promise<void> {
  await act(() => vi.advanceTimersByTimeAsync(ms));
}

/** By the name that a screen reader says; the queries for roles take long among so many. */
export function button(name: string): HTMLButtonElement {
  const found = [...document.querySelectorAll("button")].find(
    (one) => (one.ariaLabel ?? one.textContent) === name,
  );
  if (found === undefined) {
    throw new Error(`There is no button "${name}".`);
  }
  return found;
}

export function pedalState(): string | null | undefined {
  return document.querySelector('[aria-label="Pedal"] strong')?.textContent;
}

export const pointer = { button: 0, pointerId: 1 };

export async function holdPedal(): Promise<void> {
  fireEvent.pointerDown(button("Hold pedal"), pointer);
  await pass(0);
}

export function expectLetGo(by: string): void {
  expect(asked.at(-1)).toBe(by);
  expect(box.is_pedal_pressed).toBe(false);
  asked = [];
}

export const hold = '{"pedal":"hold"}';
export const drop = '{"pedal":"drop"}';

export function beginBox(): void {
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
}

export function endBox(): void {
  operation.session.stop();
  cleanup();
  vi.useRealTimers();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
}
