// SPDX-License-Identifier: Apache-2.0
// The console in a real browser against a running system, which verification/system/test_console.rb starts. After
// START_UP the axes home while the pedal is pressed. Needed from the environment:
//   BORESIGHT_URL       where the console is served
//   BORESIGHT_HTTP_PID  process of the server
//   BORESIGHT_SIMCTL    command that hands orders to the simulated box
//   BORESIGHT_START_UP  address at which a request makes the test's client command START_UP
//   BORESIGHT_SCREENSHOT  optional: file for a picture of the console
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { chromium, type Browser, type Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";

function variable(name: string): string {
  const value = process.env[name];
  if (value === undefined) {
    throw new Error(
      `${name} is not set; run verification/system/test_console.rb`,
    );
  }
  return value;
}

const url = variable("BORESIGHT_URL");
const serverPid = Number(variable("BORESIGHT_HTTP_PID"));
const [simctl = "", ...simctlArguments] =
  variable("BORESIGHT_SIMCTL").split(" ");
const startUpUrl = variable("BORESIGHT_START_UP");
/** A bound against hanging, and no judgement. */
const patience = { timeout: 120_000 };
const problems: string[] = [];
const origins = new Set<string>();
let browser: Browser;
let page: Page;

function simulate(order: string): void {
  execFileSync(simctl, [...simctlArguments, ...order.split(" ")]);
}

/** Arms homing. */
async function startUp(): Promise<void> {
  simulate("pedal release");
  await fetch(startUpUrl);
  await waitForText(".banner-next", "Press and hold the pedal.");
}

async function workphase(): Promise<string> {
  const response = await fetch(new URL("/api/v1/status", url));
  const status = (await response.json()) as { workphase: { name: string } };
  return status.workphase.name;
}

function lampWord(label: string) {
  return page.locator(".lamp", { hasText: label }).locator(".lamp-word");
}

function field(axis: string, name: "setpoint" | "position") {
  return page.locator(`[data-axis="${axis}"] [data-field="${name}"]`);
}

function waitForText(selector: string, text: string) {
  return page.locator(selector, { hasText: text }).waitFor();
}

/** For the manual, when asked for: the first stage of homing is over, the second runs. */
async function takePicture(): Promise<void> {
  const path = process.env.BORESIGHT_SCREENSHOT;
  if (path !== undefined) {
    await page
      .locator('[data-axis="insertion"][data-reference="verified"]')
      .waitFor();
    await page.locator('[data-axis="yaw"][data-level="active"]').waitFor();
    await page.screenshot({ path });
  }
}

beforeAll(async () => {
  browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu"],
  });
  page = await browser.newPage({ viewport: { width: 1440, height: 980 } });
  page.setDefaultTimeout(patience.timeout);
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") {
      problems.push(message.text());
    }
  });
  page.on("request", (request) => origins.add(new URL(request.url()).origin));
  await page.goto(url);
  await page.locator("[data-axis]").first().waitFor();
  await startUp();
});

afterAll(async () => {
  simulate("pedal release");
  await browser.close();
});

test("SWR-CON-001 the banner asks for the pedal after START_UP", async () => {
  await waitForText(".banner-next", "Press and hold the pedal.");
  await waitForText(".banner-state", "START UP");
});

test("SWR-CON-003 there is a row for each axis", async () => {
  const names = await page.locator("[data-axis] th").allTextContents();
  expect(names).toEqual([
    "head",
    "feet",
    "lateral",
    "insertion",
    "rotation",
    "pitch",
    "yaw",
  ]);
});

test("SWR-CON-005 each axis says that the pedal is missing", async () => {
  const rows = page.locator("[data-axis] .axis-permit");
  for (const text of await rows.allTextContents()) {
    expect(text).toContain("pedal released");
  }
});

test("SWR-CON-003 the position moves while the pedal is pressed", async () => {
  const before = await field("insertion", "position").textContent();
  simulate("pedal press");
  await expect
    .poll(() => field("insertion", "position").textContent(), patience)
    .not.toBe(before);
});

test("SWR-CON-002 the pedal's lamp changes its word and its shape", async () => {
  await expect
    .poll(() => lampWord("Pedal").textContent(), patience)
    .toBe("PRESSED");
  const shape = page.locator('.lamp:has-text("Pedal") .shape');
  expect(await shape.getAttribute("data-shape")).toBe("active");
  await takePicture();
  simulate("pedal release");
  await expect
    .poll(() => lampWord("Pedal").textContent(), patience)
    .toBe("RELEASED");
  expect(await shape.getAttribute("data-shape")).toBe("normal");
});

test("SWR-CON-004 a frozen server is seen to be stale and recovers", async () => {
  process.kill(serverPid, "SIGSTOP");
  try {
    await waitForText(".banner", "DATA STALE");
    const panels = page.locator(".panels");
    expect(
      await panels.evaluate((all) => getComputedStyle(all).filter),
    ).toContain("grayscale(1)");
  } finally {
    process.kill(serverPid, "SIGCONT");
  }
  await page.locator('.panels[data-freshness="live"]').waitFor();
  await page.locator(".banner-stale").waitFor({ state: "detached" });
});

test("SWR-CON-002 the accessibility rules of WCAG 2.2 AA are kept in both themes", async () => {
  const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
  await page.evaluate(readFileSync(axe, "utf8"));
  for (let theme = 0; theme < 2; theme++) {
    const violations = (await page.evaluate(
      `axe.run().then((result) => result.violations.map((one) => one.id + ": " + one.nodes[0].html))`,
    )) as string[];
    expect(violations).toEqual([]);
    await page.locator(".theme-button").click();
  }
});

test("SWR-CON-002 what can be pressed is large enough", async () => {
  for (const button of await page.locator("button").all()) {
    const box = await button.boundingBox();
    expect(box?.height).toBeGreaterThanOrEqual(36);
    expect(box?.width).toBeGreaterThanOrEqual(36);
  }
});

test("SWR-HTTP-002 the stop button stops and says so", async () => {
  await page.getByRole("button", { name: "STOP MOTION" }).click();
  await waitForText(".stop-result", "Control has stopped all motion.");
  expect(await workphase()).toBe("STOP");
  await waitForText(".banner-state", "STOP");
});

test("SWR-HTTP-002 Escape stops from anywhere", async () => {
  await page.reload();
  await page.locator(".log").focus();
  await page.keyboard.press("Escape");
  await waitForText(".stop-result", "Control has stopped all motion.");
});

test("SWR-HTTP-004 the browser has nothing to complain of and asks nobody else", () => {
  expect(problems).toEqual([]);
  expect([...origins]).toEqual([new URL(url).origin]);
});
