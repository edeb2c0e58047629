// SPDX-License-Identifier: Apache-2.0
// The page with a robot in it, opened as a file in a real browser: it homes under the pedal and stops with its release.
// verification/site/test_site.rb runs it. Needed from the environment:
//   BORESIGHT_PAGE  the page's address
//   BORESIGHT_FIGURES  file for what was measured
//   BORESIGHT_RECORDING, BORESIGHT_DAMAGED  a recording, and one that was changed
//   BORESIGHT_SCREENSHOT  optional: file for a picture of it
import { readFileSync, writeFileSync } from "node:fs";
import { type Browser, type Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { findingsOf, openPage, within } from "./opened_page";

const address = process.env.BORESIGHT_PAGE ?? "";
const recordings = new URL("replay.html", address).href;
const figures = process.env.BORESIGHT_FIGURES;
const { BORESIGHT_RECORDING: recording = "", BORESIGHT_DAMAGED: damaged = "" } =
  process.env;
const picture = process.env.BORESIGHT_SCREENSHOT;
const LOOK_MS = 100;
const STILL_CYCLES = 300;
let browser: Browser;
let page: Page;
let asked: string[];
let problems: string[];
let openedAt = 0;

function button(name: string) {
  return page.getByRole("button", { name, exact: true });
}

function sign(word: string) {
  return page.locator(".sign-word", { hasText: word });
}

const keeper = () => page.getByRole("switch", { name: "Keep pedal pressed" });

async function isKept(): Promise<boolean> {
  return (await keeper().getAttribute("aria-checked")) === "true";
}

async function arm(): Promise<void> {
  if (await button("Take command").isVisible()) {
    await button("Take command").click();
  }
  await page
    .getByRole("region", { name: "Procedure", exact: true })
    .getByRole("button", { name: "START UP" })
    .click();
  await page.getByText("Press and hold the pedal.").first().waitFor();
}

/** Takes anew the command or the pedal that a pause of the machine has taken away. */
async function pressUntilItMoves(): Promise<void> {
  while (!(await sign("MOVING").isVisible())) {
    if (await button("Take command").isVisible()) {
      await arm();
    }
    if (!(await isKept())) {
      await keeper().and(page.locator(":enabled")).click();
    }
    await page.waitForTimeout(LOOK_MS);
  }
}

/** A robot of its own, which is not homed: one that is has no reason to move until it is commanded. */
async function beginAnew(): Promise<void> {
  await page.goto(address);
  await page.getByText("Logged in as code (engineer)").waitFor();
  await button("Open the simulated box").click();
}

/** In the motion of its homing: no time passes there, so that a slow machine is in time. */
async function pauseInMotion(): Promise<void> {
  do {
    await beginAnew();
    await arm();
    await pressUntilItMoves();
    await button("Pause").click();
    await button("One cycle").and(page.locator(":enabled")).waitFor();
  } while (!(await sign("MOVING").isVisible()));
}

async function breakCard(): Promise<void> {
  await page.getByText("Gate, probe and faults").click();
  await page
    .getByRole("combobox", { name: "Fault" })
    .selectOption("card_fault silent");
  await button("Do it").click();
}

async function release(): Promise<void> {
  if (await isKept()) {
    await keeper().click();
  }
  await page
    .getByRole("group", { name: "Pedal" })
    .getByText("released")
    .waitFor();
}

async function cycle(): Promise<number> {
  const said = await page.locator(".simulation-time").innerText();
  return Number(/cycle (\d+)$/.exec(said)?.[1]);
}

async function passCycles(count: number): Promise<void> {
  const end = (await cycle()) + count;
  await expect.poll(cycle, within).toBeGreaterThan(end);
}

function positions(): Promise<string[]> {
  return page.locator('[data-axis] [data-field="position"]').allInnerTexts();
}

/** Without the time of day at which an alarm was raised. */
async function readBanner(): Promise<string[]> {
  const said = await page
    .locator(".banner")
    .locator(".sign-word, .banner-why, .banner-next")
    .allInnerTexts();
  return said.map((text) => text.replace(/ Since [\d:]{8} UTC\.$/, ""));
}

beforeAll(async () => {
  openedAt = performance.now();
  ({ browser, page, asked, problems } = await openPage(address));
});

afterAll(() => browser.close());

test("SWR-SITE-013 the page says what it is", async () => {
  await page.getByRole("note").getByText("No robot moves.").waitFor();
  await page.getByText(/^File [0-9a-f]{8}, build \S+$/).waitFor();
});

test("SWR-SITE-010 it has logged in by itself, and the axes home under the pedal", async () => {
  await page.getByText("Logged in as code (engineer)").waitFor();
  await button("Open the simulated box").click();
  await arm();
  await pressUntilItMoves();
  if (figures !== undefined) {
    writeFileSync(figures, String(Math.round(performance.now() - openedAt)));
  }
});

test("SWR-SITE-011 they stand when it is released, and STOP is heard", async () => {
  await release();
  await sign("MOVING").waitFor({ state: "detached" });
  const stood = await positions();
  await passCycles(STILL_CYCLES);
  expect(stood).not.toEqual([]);
  expect(await positions()).toEqual(stood);
  await page.getByRole("button", { name: "STOP MOTION" }).click();
  await page.locator(".banner-state strong", { hasText: "STOP" }).waitFor();
});

/** Faults in motion, their remedies, and the texts that are read then. */
const faults = [
  {
    title: "SWR-SITE-022 the pedal is released in motion, and that is read",
    cause: () => keeper().click(),
    mend: () => Promise.resolve(),
    read: [
      "ARMED",
      "The pedal is not pressed: press it.",
      "Press and hold the pedal.",
    ],
  },
  {
    title: "SWR-SITE-023 the e-stop is pulled in motion, and that is read",
    cause: () => button("Pull e-stop").click(),
    mend: () => button("Reset e-stop").click(),
    read: [
      "E-STOP",
      "The e-stop is pulled: release it.",
      "Release the e-stop.",
    ],
  },
  {
    title: "SWR-SITE-024 a card is lost in motion, and that is read",
    cause: breakCard,
    mend: () => page.getByRole("button", { name: /^Mend / }).click(),
    read: [
      "CARD LOST",
      expect.stringMatching(
        /^Card \d \(\w+\) is lost\. No frame .*: check its cable and its supply\.$/,
      ) as string,
      expect.stringMatching(
        /^Check the card .* card \d: CARD LOST\.$/,
      ) as string,
    ],
  },
];

for (const { title, cause, mend, read } of faults) {
  test(title, async () => {
    await pauseInMotion();
    await cause();
    await button("Real time").click();
    await expect.poll(readBanner, within).toEqual(read);
    const stood = await positions();
    await passCycles(STILL_CYCLES);
    expect(await positions()).toEqual(stood);
    expect(await findingsOf(page)).toBe("");
    await release();
    await mend();
  });
}

test("SWR-SITE-014 time stands still, and goes on by one cycle", async () => {
  await button("Pause").click();
  await button("One cycle").and(page.locator(":enabled")).waitFor();
  await page.waitForTimeout(LOOK_MS);
  const before = await cycle();
  await button("One cycle").click();
  await expect.poll(cycle, within).toBeGreaterThan(before);
  await page.locator('.panels[data-freshness="live"]').waitFor();
  await button("Real time").click();
  await passCycles(1);
});

test("SWR-SITE-015 nothing has left the page, and nothing in it was refused", () => {
  const others = asked.filter((url) => !/^(file|blob|data):/.test(url));
  expect(others).toEqual([]);
  const files = asked.filter((url) => url.startsWith("file:"));
  expect([...new Set(files)]).toEqual([address]);
  expect(problems).toEqual([]);
});

test("SWR-SITE-013 everybody can read it", async () => {
  if (picture !== undefined) {
    await page.screenshot({ path: picture });
  }
  expect(await findingsOf(page)).toBe("");
});

test("SWR-SITE-012 another robot is a link away", async () => {
  await page.getByRole("link", { name: "prostate", exact: true }).click();
  await page
    .locator(".simulation-names strong", { hasText: "prostate" })
    .waitFor();
});

/** State of the handle at the simulated box, once it is that. */
async function handleIs(state: string): Promise<void> {
  await page
    .getByRole("group", { name: "Handle", exact: true })
    .getByText(state, { exact: true })
    .waitFor();
}

async function readingOfHand(): Promise<number> {
  const cells = page
    .getByRole("row", { name: /^hand / })
    .getByRole("cell")
    .allInnerTexts();
  return Number((await cells)[1]);
}

// The robot that has a force sensor is not homed, so that no force was zeroed.
test("SWR-CON-611 a hand presses by keys with the chosen force, and nothing is drawn of what is doubtful", async () => {
  await button("Open the simulated box").click();
  await page
    .getByRole("group", { name: "Hand", exact: true })
    .getByRole("combobox")
    .selectOption("2000");
  await button("Hold handle").focus();
  await page.keyboard.down("Space");
  await handleIs("held by this page");
  await page.keyboard.up("Space");
  await handleIs("released");
  await page.getByRole("link", { name: "Status", exact: true }).click();
  const free = await readingOfHand();
  await page.getByRole("switch", { name: "Keep handle pressed" }).click();
  await expect.poll(readingOfHand, within).toBeGreaterThan(free + 200);
  await page.getByRole("link", { name: "Modes", exact: true }).click();
  const plots = page.getByRole("region", { name: "Force and depth" });
  await plots.getByText("hand doubtful", { exact: true }).waitFor();
  await expect.poll(() => plots.locator(".plot").count(), within).toBe(3);
  const curve = plots.locator(".plot .plot-line-hand").first();
  expect(await curve.getAttribute("d")).toBe("");
  expect(await findingsOf(page)).toBe("");
});

test("SWR-SITE-028 a link is played, and a bad one is refused in words", async () => {
  await page.goto(`${address}#robot=neuro&seed=7&inputs=100:estop,pull`);
  await page
    .locator(".banner-state strong", { hasText: "EMERGENCY" })
    .waitFor();
  await page.goto(`${address}#robot=neuro&seed=7&inputs=9:pedal,kick`);
  const refusal = page.getByRole("alert").getByText("“pedal kick” is no order");
  await refusal.waitFor();
  await page.goto(`${address}#robot=${"nobody".repeat(20)}`);
  const nobody = page.getByRole("alert").getByText("is refused. There is no");
  await nobody.waitFor();
  await page.getByRole("link", { name: "A robot without it" }).click();
  await nobody.waitFor({ state: "detached" });
});

test("SWR-SITE-032 time goes back, and what would be if is answered there", async () => {
  await expect.poll(cycle, within).toBeGreaterThan(1);
  await button("Pause").click();
  await page.getByText("Back in time, share, what if").click();
  await button("Back one cycle").click();
  await page
    .getByText(/^It has been to cycle \d+\. When time goes on/)
    .waitFor();
  await page.getByLabel("What if").fill("estop pull");
  await button("Compare").click();
  await page.locator(".simulation-lines", { hasText: "estop" }).waitFor();
  expect(await findingsOf(page)).toBe("");
});

test("SWR-SITE-035 a recording is opened in the page beside it, and shown at its events", async () => {
  await page.goto(address);
  await page.getByRole("link", { name: "Open a recording" }).click();
  await page.getByLabel("Open a recording").setInputFiles(recording);
  await page
    .getByText(/^Bit-exact as far as it goes: \d+ of at least \d+ cycles/)
    .waitFor();
  await button("Next event").click();
  await page
    .locator(".replay-now")
    .filter({ hasText: /^cycle [1-9]/ })
    .waitFor();
  await page.locator(".banner").waitFor();
});

test("SWR-SITE-038 it has sent nothing, everybody can read it, also on a narrow screen", async () => {
  expect(await findingsOf(page)).toBe("");
  await page.setViewportSize({ width: 320, height: 640 });
  const [width = 0, room] = await page.evaluate(() => [
    document.documentElement.scrollWidth,
    document.documentElement.clientWidth,
  ]);
  expect(width).toBeLessThanOrEqual(room ?? 0);
  const others = asked
    .filter((url) => !/^(blob|data):/.test(url))
    .filter((url) => ![address, recordings].includes(url.split("#")[0] ?? ""));
  expect([others, problems]).toEqual([[], []]);
});

test("SWR-SITE-036 a damaged one that is dropped is refused with the place", async () => {
  const transfer = await page.evaluateHandle((text) => {
    const data = new DataTransfer();
    const bytes = Uint8Array.from(atob(text), (one) => one.charCodeAt(0));
    data.items.add(new File([bytes], "damaged.bsr"));
    return data;
  }, readFileSync(damaged).toString("base64"));
  await page
    .locator(".file-drop")
    .dispatchEvent("drop", { dataTransfer: transfer });
  await page
    .getByRole("alert")
    .getByText(/Block \d+, bytes \d+\.\.\d+: the hash does not match/)
    .waitFor();
  expect(await page.locator(".timeline").count()).toBe(0);
});
