// SPDX-License-Identifier: Apache-2.0
// Rule under test: each axis shows what is known of it, is commanded by the page that has authority, and a position is
// changed only after a question.
import { act, fireEvent, render, screen, within } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { Modes, Role } from "@interface";
import {
  makeCommander,
  makeOutlook,
  plainActs,
  refusedHere,
  type Commander,
  leave,
} from "../../testing/commander";
import { makeAxis, makeBlockedAxis, makeRobot } from "../../testing/robot";
import { Motors } from "./Motors";

let commander: Commander;
const manual = {
  workphase: { name: "MANUAL", text: "" },
  order: "none",
} as const;
const pair = [
  makeAxis("head"),
  makeAxis("yaw", { unit: "deg", power: "disabled" }),
];

function motors(outlook: Modes, change: object = manual, axes = pair) {
  const robot = makeRobot({ authority: commander.authority, ...change }, axes);
  return (
    <Motors robot={robot} outlook={outlook} operation={commander.operation} />
  );
}

async function show(
  outlook: Modes,
  role: Role = "ENGINEER",
  change: object = manual,
  axes = pair,
) {
  commander = await makeCommander(role);
  return render(motors(outlook, change, axes));
}

function row(axis: string): HTMLElement {
  const found = document.querySelector<HTMLElement>(`[data-axis="${axis}"]`);
  if (found === null) {
    throw new Error(`no motor ${axis}`);
  }
  return found;
}

function sliderOf(axis: string): HTMLElement {
  return screen.getByLabelText(`Set-point of ${axis}`);
}

function button(axis: string, name: string): HTMLButtonElement {
  return within(row(axis)).getByText<HTMLButtonElement>(name, {
    selector: "button",
  });
}

function press(axis: string, name: string): void {
  fireEvent.click(button(axis, name));
}

afterEach(() => leave(commander));

function barJog(outlook: Modes, upwards: string, downwards: string | null) {
  const axis = {
    axis: "head",
    upwards: "SWITCH_ZONE" as const,
    upwards_reason: upwards,
    downwards: downwards === null ? null : ("NEEDLE_IN" as const),
    downwards_reason: downwards,
  };
  const modes = outlook.modes.map((mode) =>
    mode.name === "JOG" ? { ...mode, axes: [axis] } : mode,
  );
  return { ...outlook, modes };
}

test("SWR-MODE-013 a way that is barred to one axis is reported with it, and the other way open", async () => {
  await show(barJog(makeOutlook("JOG"), "The switch.", null));
  expect(button("head", "+1.00 mm").disabled).toBe(true);
  expect(button("head", "−1.00 mm").disabled).toBe(false);
  expect(row("head").textContent).toContain("Jog upwards: The switch.");
});

test("SWR-MODE-013 what bars both ways is reported once", async () => {
  await show(barJog(makeOutlook("JOG"), "The needle.", "The needle."));
  expect(row("head").textContent).toContain("Jog: The needle.");
  expect(row("head").textContent).not.toContain("wards");
});

test("SWR-CON-017 an axis is jogged by the step that was chosen", async () => {
  await show(makeOutlook("JOG"));
  fireEvent.change(screen.getByLabelText(/^Step/), { target: { value: "5" } });
  press("yaw", "−5.00 °");
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/motors/yaw/jog",
      body: { id: 1, distance: -5, unit: "deg" },
    },
  ]);
});

test("SWR-CON-017 an axis goes to a position that is a number", async () => {
  await show(makeOutlook("JOG"));
  const place = screen.getByLabelText("Position of head");
  for (const value of ["", "1 2", "x", "1e999"]) {
    fireEvent.change(place, { target: { value } });
    expect(button("head", "Go to").disabled, value).toBe(true);
  }
  fireEvent.change(place, { target: { value: "-2.5" } });
  press("head", "Go to");
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/motors/head/jog",
      body: { id: 1, position: -2.5, unit: "mm" },
    },
  ]);
});

test.each([
  ["head", "Home head", "HOME_AXIS", "/api/v1/motors/head/home"],
  ["head", "Disable head", "DISABLE_AXIS", "/api/v1/motors/head/disable"],
  ["yaw", "Enable yaw", "ENABLE_AXIS", "/api/v1/motors/yaw/enable"],
])("SWR-CON-017 of %s: %s is commanded", async (axis, name, mode, path) => {
  await show(makeOutlook(mode));
  press(axis, name);
  expect(commander.acts()).toEqual([{ path, body: { id: 1 } }]);
});

test.each([
  ["Set home", "set-home"],
  ["Clear position", "clear"],
  ["Confirm position", "confirm"],
])("SWR-CON-017 %s asks before it is done", async (name, path) => {
  await show(makeOutlook(...plainActs));
  press("head", `${name}…`);
  expect(commander.acts()).toEqual([]);
  expect(document.activeElement?.textContent).toBe("Cancel");
  press("head", "Cancel");
  expect(commander.acts()).toEqual([]);
  press("head", `${name}…`);
  press("head", name);
  expect(commander.acts()).toEqual([
    { path: `/api/v1/motors/head/${path}`, body: { id: 1 } },
  ]);
});

test("SWR-CON-044 each act on an axis is offered as the server says it, and each reason stands once", async () => {
  const outlook = makeOutlook("JOG", "HOME_AXIS", "CONFIRM_AXIS");
  const reason = "The role of this account does not allow it.";
  await show({
    ...outlook,
    commands: outlook.commands.map((one) =>
      one.name === "SET_HOME" || one.name === "CLEAR_AXIS"
        ? { ...one, reason }
        : one,
    ),
  });
  expect(button("head", "Set home…").disabled).toBe(true);
  expect(button("head", "Clear position…").disabled).toBe(true);
  expect(button("head", "Confirm position…").disabled).toBe(false);
  expect(button("head", "Disable head").disabled).toBe(true);
  expect(screen.getByText(`Set home, Clear position: ${reason}`)).toBeTruthy();
  expect(screen.getByText(`Enable, Disable: ${refusedHere}`)).toBeTruthy();
});

test("SWR-CON-017 what the server would refuse cannot be pressed, and it is said once for all axes", async () => {
  await show(makeOutlook(), "ENGINEER", { order: "none" });
  for (const name of ["+1.00 mm", "Go to", "Home head", "Disable head"]) {
    expect(button("head", name).disabled, name).toBe(true);
  }
  expect(screen.getAllByText(/^Jog, Home, .*: /)).toHaveLength(1);
  const slider = sliderOf("head");
  expect(slider.getAttribute("aria-disabled")).toBe("true");
});

test("SWR-CON-025 the slider of a page that does not command is locked", async () => {
  await show(makeOutlook("JOG"), "OBSERVER");
  const slider = sliderOf("head");
  expect(slider.getAttribute("aria-disabled")).toBe("true");
  fireEvent.keyDown(slider, { key: "ArrowRight" });
  fireEvent.keyUp(slider, { key: "ArrowRight" });
  expect(commander.acts()).toEqual([]);
});

test("SWR-CON-025 a slider that is let go arms a jog, and stands there until that is done", async () => {
  const outlook = makeOutlook("JOG");
  const { rerender } = await show(outlook);
  fireEvent.keyDown(sliderOf("head"), { key: "ArrowRight" });
  await act(async () => {
    fireEvent.keyUp(sliderOf("head"), { key: "ArrowRight" });
    await Promise.resolve();
  });
  expect(commander.acts()).toEqual([
    {
      path: "/api/v1/motors/head/jog",
      body: { id: 1, position: 13.5, unit: "mm" },
    },
  ]);
  expect(sliderOf("head").getAttribute("aria-valuenow")).toBe("13.5");
  const mode = { name: "JOG", text: "" };
  rerender(motors(outlook, { ...manual, order: "waiting", mode }));
  expect(sliderOf("head").getAttribute("aria-valuenow")).toBe("13.5");
  rerender(motors(outlook));
  expect(sliderOf("head").getAttribute("aria-valuenow")).toBe("12.5");
});

test("SWR-CON-025 what was refused is not shown as asked for", async () => {
  await show(makeOutlook("JOG"));
  const detail = "An axis would leave its soft limits.";
  commander.answers["/api/v1/motors/head/jog"] = {
    status: 409,
    body: { detail, axis: "head", limit: "upper" },
  };
  const slider = sliderOf("head");
  fireEvent.keyDown(slider, { key: "PageUp" });
  fireEvent.keyUp(slider, { key: "PageUp" });
  expect((await screen.findByRole("alert")).textContent).toContain(detail);
  expect(slider.getAttribute("aria-valuenow")).toBe("12.5");
});

test("SWR-CON-026 a motor shows its numbers and its switches", async () => {
  const axis = makeAxis("head", {
    at_upper_switch: true,
    output_percent: -37.2,
  });
  await show(makeOutlook(), "ENGINEER", manual, [axis]);
  const text = screen.getByRole("listitem", { name: "head" }).textContent;
  expect(text).toContain("Set-point12.50 mm");
  expect(text).toContain("Position10.00 mm");
  expect(text).toContain("Speed1.0 mm/s");
  expect(text).toContain("Output−37 %");
  expect(text).toContain("lower switch free");
  expect(text).toContain("upper switch ACTIVE");
});

test.each(["fresh", "lost", "approach"] as const)(
  "SWR-CON-026 the position of an axis that is %s is unknown, and its slider is locked",
  async (reference) => {
    const axes = [makeAxis("head", { reference })];
    await show(makeOutlook("JOG"), "ENGINEER", manual, axes);
    expect(row("head").textContent).toContain(
      "Positionunknowncounted 10.00 mm",
    );
    const slider = sliderOf("head");
    expect(slider.getAttribute("aria-disabled")).toBe("true");
    expect(button("head", "+1.00 mm").disabled).toBe(false);
  },
);

test("SWR-CON-005 a motor says what stands against it alone, and all of them what stands against all", async () => {
  const homed = { name: "NOT_HOMED", text: "The axis is not homed." } as const;
  const pulled = { name: "ESTOP_PULLED", text: "It is pulled." } as const;
  const axes = [
    makeBlockedAxis("head", pulled),
    makeBlockedAxis("yaw", pulled, homed),
  ];
  await show(makeOutlook(), "ENGINEER", manual, axes);
  expect(screen.getAllByText("It is pulled.")).toHaveLength(1);
  expect(within(row("yaw")).getByText("The axis is not homed.")).toBeTruthy();
});
