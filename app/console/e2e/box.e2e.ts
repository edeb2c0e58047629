// SPDX-License-Identifier: Apache-2.0
// The drawer of the simulated box in a real browser, on the running system of verification/system/http/test_http_box.rb.
// Needed from the environment:
//   BORESIGHT_URL    where the console is served
//   BORESIGHT_LOGIN  name and password, with a space between them
import { chromium, type Browser, type Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import type { Box } from "@interface";

const url = process.env.BORESIGHT_URL ?? "";
const [name = "", password = ""] = (process.env.BORESIGHT_LOGIN ?? "").split(
  " ",
);
/** A bound against hanging, and no judgement. */
const within = { timeout: 120_000 };
let browser: Browser;
let page: Page;

async function box(): Promise<Box> {
  return (await (await fetch(new URL("/api/v1/box", url))).json()) as Box;
}

function expectPedal(isPressed: boolean) {
  return expect
    .poll(async () => (await box()).is_pedal_pressed, within)
    .toBe(isPressed);
}

function press(label: string) {
  return page.getByRole("button", { name: label, exact: true }).click();
}

beforeAll(async () => {
  browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu"],
  });
  page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  page.setDefaultTimeout(within.timeout);
  await page.goto(url);
  await press("Log in…");
  await page.locator('input[name="name"]').fill(name);
  await page.locator('input[name="password"]').fill(password);
  await press("Log in");
  await press("Open the simulated box");
  await page.locator(".hold-button:enabled").first().waitFor();
});

afterAll(() => browser.close());

test("the key holds the pedal, and a click elsewhere does not", async () => {
  // Tried again where the machine pauses for longer than the box waits.
  const isHeld = async () => {
    await page.getByRole("button", { name: "Hold pedal" }).focus();
    await page.keyboard.down(" ");
    await page.waitForTimeout(600); // Shorter than the box waits.
    const isPressed = (await box()).is_pedal_pressed;
    await page.keyboard.up(" ");
    await expectPedal(false);
    return isPressed;
  };
  await expect.poll(isHeld, within).toBe(true);
});

test("the pointer may leave the button while it is down", async () => {
  // Tried again where the machine pauses for longer than the box waits.
  const staysPressed = async () => {
    await page.getByRole("button", { name: "Hold pedal" }).hover();
    await page.mouse.down();
    await expectPedal(true);
    await page.mouse.move(5, 300);
    await page.waitForTimeout(1600); // Longer than the box waits.
    const isPressed = (await box()).is_pedal_pressed;
    await page.mouse.up();
    await expectPedal(false);
    return isPressed;
  };
  await expect.poll(staysPressed, within).toBe(true);
});

test("a fault is caused and mended", async () => {
  await page.getByText("Gate, probe and faults").click();
  await page
    .getByRole("combobox", { name: "Fault" })
    .selectOption("encoder_fault half");
  await press("Do it");
  await page.getByText("encoder loses every other edge").last().waitFor();
  await press("Mend 2 slide: encoder");
  await page.getByText("Nothing is wrong at the box.").waitFor();
});

test("it fits into a narrow page, and STOP is whole", async () => {
  await page.setViewportSize({ width: 320, height: 640 });
  const drawer = await page.locator(".box").boundingBox();
  expect(drawer?.x).toBeGreaterThanOrEqual(0);
  expect((drawer?.x ?? 0) + (drawer?.width ?? 0)).toBeLessThanOrEqual(320);
  const inside = await page
    .locator(".box-content")
    .evaluate((one) => [one.scrollWidth, one.clientWidth] as const);
  expect(inside[0]).toBeLessThanOrEqual(inside[1]);
  await page.getByRole("button", { name: "STOP MOTION" }).click();
});

test("a page that is closed has let go", async () => {
  await page.getByRole("switch", { name: "Keep pedal pressed" }).click();
  await expectPedal(true);
  await page.close();
  await expectPedal(false);
});
