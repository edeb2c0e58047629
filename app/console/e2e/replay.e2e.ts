// SPDX-License-Identifier: Apache-2.0
// A page that boresight-replay has written, opened from its file; verification/system/test_replay_files.rb runs this.
//   BORESIGHT_PAGE     the file
//   BORESIGHT_EVENT    sentence of an event in it
//   BORESIGHT_CYCLE    cycle of that event
//   BORESIGHT_DRIVEN   last cycle before it in which a card is driven, and that card's slot
//   BORESIGHT_SCREENSHOT  optional: file for a picture of the page
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { chromium, type Browser, type Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";

/** A bound against hanging, and no judgement. */
const patience = { timeout: 120_000 };
const { BORESIGHT_PAGE: file = "", BORESIGHT_SCREENSHOT: picture } =
  process.env;
const { BORESIGHT_EVENT: sentence = "", BORESIGHT_CYCLE: cycle = "" } =
  process.env;
const [driven = "", slot = ""] = (process.env.BORESIGHT_DRIVEN ?? "").split(
  " ",
);
const problems: string[] = [];
let browser: Browser;
let page: Page;

beforeAll(async () => {
  browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu"],
  });
  page = await browser.newPage({ viewport: { width: 1440, height: 980 } });
  page.setDefaultTimeout(patience.timeout);
  page.on("console", (message) => problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("request", (request) => {
    if (request.url() !== pathToFileURL(file).href) {
      problems.push(request.url());
    }
  });
  await page.goto(pathToFileURL(file).href);
  await page.locator(".timeline").waitFor();
});

afterAll(async () => {
  await browser.close();
});

/** The drive mode of that card. */
async function driveMode(): Promise<string> {
  const table = page.getByRole("region", { name: "Frames by slot" });
  const heads = await table.getByRole("columnheader").allTextContents();
  const column = heads.findIndex((head) => head.startsWith(`${slot},`));
  const row = table.locator('[data-field="drive_mode"]');
  return (await row.locator("th, td").nth(column).textContent()) ?? "";
}

test("SWR-REPLAY-018 an event is shown in its cycle, and the last drive before it in its own", async () => {
  await page
    .getByRole("button", { name: `Go to cycle ${cycle}: ${sentence}` })
    .click();
  const now = page.locator(".replay-now");
  await now.filter({ hasText: `cycle ${cycle},` }).waitFor();
  expect(await now.textContent()).toContain("ARMED");
  expect(await driveMode()).toBe("OFF");
  await page.getByRole("slider", { name: "Cycle" }).fill(driven);
  await now.filter({ hasText: `cycle ${driven},` }).waitFor();
  expect(await driveMode()).not.toBe("OFF");
  if (picture !== undefined) {
    await page.screenshot({ path: picture, fullPage: true });
  }
});

test("SWR-REPLAY-015 it asks for nothing, and has no trouble with its own policy", () => {
  expect(problems).toEqual([]);
});

test("SWR-REPLAY-018 axe finds nothing", async () => {
  const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
  await page.evaluate(readFileSync(axe, "utf8"));
  const found: { violations: { id: string; nodes: { html: string }[] }[] } =
    await page.evaluate(`axe.run({ resultTypes: ["violations"] })`);
  const findings = found.violations.flatMap(({ id, nodes }) =>
    nodes.map(({ html }) => `${id}: ${html}`),
  );
  expect(findings.join("\n")).toBe("");
});

test("SWR-REPLAY-018 it has room on a narrow screen", async () => {
  await page.setViewportSize({ width: 320, height: 640 });
  const [width, room] = await page.evaluate(() => [
    document.documentElement.scrollWidth,
    document.documentElement.clientWidth,
  ]);
  expect(width).toBeLessThanOrEqual(room ?? 0);
});
