// SPDX-License-Identifier: Apache-2.0
// A page that boresight-replay has written, opened from its file; verification/system/recording/test_replay_files.rb runs this.
//   BORESIGHT_PAGE     the file
//   BORESIGHT_EVENT    sentence of an event in it
//   BORESIGHT_CYCLE    cycle of that event
//   BORESIGHT_DRIVEN   last cycle before it in which a card is driven, and that card's slot
//   BORESIGHT_SCREENSHOT  optional: file for a picture of the page
import { pathToFileURL } from "node:url";
import { type Browser, type Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { findingsOf, openPage } from "./opened_page";

const { BORESIGHT_PAGE: file = "", BORESIGHT_SCREENSHOT: picture } =
  process.env;
const { BORESIGHT_EVENT: sentence = "", BORESIGHT_CYCLE: cycle = "" } =
  process.env;
const [driven = "", slot = ""] = (process.env.BORESIGHT_DRIVEN ?? "").split(
  " ",
);
const address = pathToFileURL(file).href;
let browser: Browser;
let page: Page;
let asked: string[];
let problems: string[];

beforeAll(async () => {
  ({ browser, page, asked, problems } = await openPage(address));
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
  expect(asked.filter((url) => url !== address)).toEqual([]);
  expect(problems).toEqual([]);
});

test("SWR-REPLAY-018 axe finds nothing", async () => {
  expect(await findingsOf(page)).toBe("");
});

test("SWR-REPLAY-018 it has room on a narrow screen", async () => {
  await page.setViewportSize({ width: 320, height: 640 });
  const [width, room] = await page.evaluate(() => [
    document.documentElement.scrollWidth,
    document.documentElement.clientWidth,
  ]);
  expect(width).toBeLessThanOrEqual(room ?? 0);
});
