// SPDX-License-Identifier: Apache-2.0
// A page of the console in a real browser, on a running system that a test of verification/system/http starts. After START_UP
// the axes home while the pedal is pressed. The environment gives:
//   BORESIGHT_URL       where the console is served
//   BORESIGHT_HTTP_PID  process of the server
//   BORESIGHT_SIMCTL    command that hands orders to the simulated box
//   BORESIGHT_START_UP  address at which a request makes the test's client command START_UP
//   BORESIGHT_SCREENSHOT  optional: file for a picture of the console
import { execFileSync } from "node:child_process";
import {
  chromium,
  type Browser,
  type BrowserContext,
  type Page,
} from "playwright-core";
import { afterAll, afterEach, beforeAll } from "vitest";
import { within } from "./opened_page";

export function variable(name: string): string {
  const value = process.env[name];
  if (value === undefined) {
    throw new Error(
      `${name} is not set; run test_console.rb or test_console_stop.rb of verification/system`,
    );
  }
  return value;
}

export const url = variable("BORESIGHT_URL");
export const serverPid = Number(variable("BORESIGHT_HTTP_PID"));
const [simctl = "", ...simctlArguments] =
  variable("BORESIGHT_SIMCTL").split(" ");
const startUpUrl = variable("BORESIGHT_START_UP");
/** Messages of the browser about the page. */
export const problems: string[] = [];
/** Origins that the page has asked. */
export const origins = new Set<string>();
export const stopOrigin = new URL(url);
export let browser: Browser;
export let context: BrowserContext;
export let page: Page;

export function simulate(order: string): void {
  execFileSync(simctl, [...simctlArguments, ...order.split(" ")]);
}

/** Arms homing. */
export async function startUp(): Promise<void> {
  simulate("pedal release");
  await fetch(startUpUrl);
  await waitForText(".banner-next", "Press and hold the pedal.");
}

export async function workphase(): Promise<string> {
  const response = await fetch(new URL("/api/v1/status", url));
  const status = (await response.json()) as { workphase: { name: string } };
  return status.workphase.name;
}

export function waitForText(
  selector: string,
  text: string | RegExp,
  where = page,
) {
  return where.locator(selector, { hasText: text }).waitFor();
}

export function pressStop(where = page) {
  return where.getByRole("button", { name: "STOP MOTION" }).click();
}

export async function openTab(where = context): Promise<Page> {
  const tab = await where.newPage();
  tab.setDefaultTimeout(within.timeout);
  await tab.goto(url);
  return tab;
}

/** Pictures for those who want to look: with BORESIGHT_SCREENSHOT=DIR/NAME.png also DIR/NAME-PART.png. */
export async function takePictureOf(part: string, where = page): Promise<void> {
  const path = process.env.BORESIGHT_SCREENSHOT;
  if (path !== undefined) {
    await where.screenshot({ path: path.replace(/(\.png)?$/, `-${part}.png`) });
  }
}

export function chooseTheme(theme: "light" | "dark" | "system") {
  return page.getByLabel("Theme").selectOption(theme);
}

/** One page for all parts of a file, after START_UP; a part that failed says what the page showed then. */
export function shareOnePage(): void {
  afterEach(async ({ task }) => {
    const error = task.result?.errors?.[0];
    if (error !== undefined) {
      const shown = await page.locator("body").innerText({ timeout: 5000 });
      error.message += `\nThe page shows:\n${shown}`;
      error.stack = `${error.message}\n${error.stack ?? ""}`;
    }
  });

  beforeAll(async () => {
    browser = await chromium.launch({
      executablePath: "/usr/bin/chromium",
      args: ["--no-sandbox", "--disable-gpu"],
    });
    context = await browser.newContext({
      viewport: { width: 1440, height: 980 },
    });
    page = await context.newPage();
    page.setDefaultTimeout(within.timeout);
    page.on("pageerror", (error) => problems.push(error.message));
    page.on("console", (message) => {
      if (message.type() === "error") {
        problems.push(message.text());
      }
    });
    page.on("request", (request) => origins.add(new URL(request.url()).origin));
    await page.goto(url);
    await page.locator("[data-axis]").first().waitFor();
    stopOrigin.port = String(
      Number(
        await page
          .locator('meta[name="boresight-stop-port"]')
          .getAttribute("content"),
      ),
    );
    await startUp();
  });

  afterAll(async () => {
    simulate("pedal release");
    await browser.close();
  });
}
