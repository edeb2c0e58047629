// SPDX-License-Identifier: Apache-2.0
// The views of the console on a running system, in a real browser: banner, lamps, axes, stale data, each view in each window
// and theme, help, and the size of the first load. verification/system/http/test_console.rb starts the system; console_page.ts
// names the environment that is needed.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { type Page } from "playwright-core";
import { expect, test } from "vitest";
import {
  browser,
  chooseTheme,
  openTab,
  origins,
  page,
  problems,
  serverPid,
  shareOnePage,
  simulate,
  startUp,
  takePictureOf,
  url,
  waitForText,
} from "./console_page";
import { within } from "./opened_page";

shareOnePage();

function lampWord(label: string) {
  return page.locator(".lamp", { hasText: label }).locator(".lamp-word");
}

function field(axis: string, name: "setpoint" | "position") {
  return page.locator(`[data-axis="${axis}"] [data-field="${name}"]`);
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

test("SWR-CON-001 the banner asks for the pedal after START_UP", async () => {
  await waitForText(".banner-next", "Press and hold the pedal.");
  await waitForText(".banner-state", "START UP");
});

test("SWR-CON-020 banner and title say that only the pedal is missing", async () => {
  await waitForText(".sign-word", "ARMED");
  await expect.poll(() => page.title(), within).toBe("ARMED – Boresight");
});

test("SWR-CON-021 before homing a position is unknown", async () => {
  for (const cell of await field("head", "position").allTextContents()) {
    expect(cell).toBe("unknown counted 0.00 mm");
  }
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
  await waitForText(".shared-reasons", "The pedal is not pressed: press it.");
  const rows = page.locator("[data-axis] .axis-permit");
  for (const text of await rows.allTextContents()) {
    expect(text).toContain("As for every axis");
  }
});

/** How much room the progress takes, in its panel. */
async function roomOfProgress(): Promise<number | undefined> {
  const panel = page.locator(".panel", { has: page.locator(".steps") });
  return (await panel.boundingBox())?.height;
}

test("SWR-CON-047 the room of the progress is there before a motion begins", async () => {
  const before = await roomOfProgress();
  simulate("pedal press");
  await page.locator(".progress progress").waitFor();
  expect(await roomOfProgress()).toBe(before);
  await startUp();
});

test("SWR-CON-003 the position moves while the pedal is pressed", async () => {
  const before = await field("insertion", "position").textContent();
  simulate("pedal press");
  await expect
    .poll(() => field("insertion", "position").textContent(), within)
    .not.toBe(before);
});

test("SWR-CON-002 the pedal's lamp changes its word and its shape", async () => {
  await expect
    .poll(() => lampWord("Pedal").textContent(), within)
    .toBe("PRESSED");
  const shape = page.locator('.lamp:has-text("Pedal") .shape');
  expect(await shape.getAttribute("data-shape")).toBe("active");
  await waitForText(".sign-word", "MOVING");
  await expect.poll(() => page.title(), within).toBe("MOVING – Boresight");
  await takePicture();
  simulate("pedal release");
  await expect
    .poll(() => lampWord("Pedal").textContent(), within)
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
  await page
    .locator('.banner[data-sign="stale"]')
    .waitFor({ state: "detached" });
});

/** Findings that axe cannot judge by itself, with the reason why they are accepted. */
const judged = new Map([
  [
    "color-contrast elmPartiallyObscured",
    "cut by the edge of what scrolls; the rows that are not cut have the same colours, and are judged",
  ],
  [
    "color-contrast bgOverlap",
    "scrolled beneath what sticks to an edge of the window; each is judged where it is not",
  ],
  [
    "color-contrast elmPartiallyObscuring",
    "the handle of the drawer, over what scrolls beneath it; it has a ground of its own, that of every button",
  ],
  [
    "color-contrast emptyValue",
    "a field that nothing is written in; the labels beside it have the same colours",
  ],
  [
    "color-contrast imgNode",
    "text in a drawing, which has no ground but that of its panel; the panel's texts have the same colours",
  ],
  [
    "color-contrast shortTextContent",
    "the letter of a coordinate; as the other texts in a drawing",
  ],
]);

interface Finding {
  id: string;
  nodes: { html: string; any: { data: { messageKey?: string } | null }[] }[];
}

function isJudged(id: string, { any }: Finding["nodes"][number]): boolean {
  return judged.has(`${id} ${any[0]?.data?.messageKey}`);
}

/** The rules that are broken, or that were not judged, by the element. */
async function findingsOf(where = page): Promise<string[]> {
  const found: Record<"violations" | "incomplete", Finding[]> =
    await where.evaluate(
      `axe.run({ resultTypes: ["violations", "incomplete"] })`,
    );
  const { violations, incomplete } = found;
  const open = incomplete.map(({ id, nodes }) => ({
    id,
    nodes: nodes.filter((node) => !isJudged(id, node)),
  }));
  return [...violations, ...open].flatMap(({ id, nodes }) =>
    nodes.map((node) => `${id}: ${node.html} ${JSON.stringify(node.any)}`),
  );
}

async function expectNoFinding(place: string): Promise<void> {
  const findings = await findingsOf();
  if (findings.length > 0) {
    throw new Error(`${place}:\n${findings.join("\n")}`);
  }
}

async function loadAxe(where = page): Promise<void> {
  const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
  await where.evaluate(readFileSync(axe, "utf8"));
}

const wide = { width: 1440, height: 980 };
const heights = new Map([
  [320, 640],
  [390, 844],
  [768, 1024],
  [1024, 768],
  [1440, 900],
  [1920, 1080],
]);

function resize(width: number) {
  return page.setViewportSize({ width, height: heights.get(width) ?? 900 });
}

function viewIds(): Promise<string[]> {
  return page
    .locator(".views a")
    .evaluateAll((all) =>
      all.map((one) => one.getAttribute("href")?.slice(1) ?? ""),
    );
}

async function open(view: string): Promise<void> {
  await page.locator(`.views a[href="#${view}"]`).click();
  await page.locator(".panels .panel").first().waitFor();
}

test("SWR-CON-022 the accessibility rules of WCAG 2.2 AA are kept in each view, at each width and in both themes", async () => {
  await loadAxe();
  try {
    for (const view of await viewIds()) {
      await open(view);
      for (const width of [320, 768, 1440]) {
        await resize(width);
        for (const theme of ["light", "dark"] as const) {
          await chooseTheme(theme);
          await expectNoFinding(`${view} ${width} ${theme}`);
        }
      }
    }
  } finally {
    await page.setViewportSize(wide);
    await open("procedure");
  }
});

/** Elements that reach out of the window sideways, but for those that scroll by themselves or are hidden. */
function outsideOf(where = page): Promise<string[]> {
  return where.evaluate(() => {
    const isHeld = (element: Element | null): boolean =>
      element !== null &&
      element !== document.body &&
      (getComputedStyle(element).overflowX !== "visible" ||
        isHeld(element.parentElement));
    const all = [...document.querySelectorAll("#root *")];
    const outside = all.filter((element) => {
      const { left, right } = element.getBoundingClientRect();
      return (left < -1 || right > innerWidth + 1) && !isHeld(element);
    });
    const names = outside.map(
      (element) => `${element.tagName} ${element.className}`,
    );
    return document.documentElement.scrollWidth > innerWidth
      ? ["the page", ...names]
      : names;
  });
}

/** Whether all of it can be seen, and pressed. */
function isStopWhole(where = page): Promise<boolean> {
  return where.locator(".stop-button").evaluate((button) => {
    const { left, right, top, bottom } = button.getBoundingClientRect();
    const corners = [left + 8, right - 8].flatMap((x) =>
      [top + 8, bottom - 8].map((y) => document.elementFromPoint(x, y)),
    );
    return corners.every((hit) => hit !== null && button.contains(hit));
  });
}

test("SWR-CON-022 at each width nothing leaves the window, and the stop is whole, at the top of the page and at its end", async () => {
  try {
    for (const view of await viewIds()) {
      await open(view);
      for (const width of heights.keys()) {
        await resize(width);
        await expect
          .poll(() => outsideOf(), {
            ...within,
            message: `${view} ${width}`,
          })
          .toEqual([]);
        for (const end of [0, 1e6]) {
          await page.evaluate((y) => scrollTo(0, y), end);
          await expect
            .poll(() => isStopWhole(), {
              ...within,
              message: `${view} ${width} ${end}`,
            })
            .toBe(true);
        }
      }
    }
  } finally {
    await page.setViewportSize(wide);
    await open("procedure");
  }
});

test("SWR-CON-022 enlarged to 400 %, the page is as one of 320 px, and no text is smaller than 14 px", async () => {
  try {
    await page.setViewportSize({ width: 320, height: 256 });
    await expect.poll(() => outsideOf(), within).toEqual([]);
    await expect.poll(() => isStopWhole(), within).toBe(true);
    const smallest = await page.evaluate(() =>
      Math.min(
        ...[...document.querySelectorAll("#root *")]
          .filter(({ textContent }) => textContent !== "")
          .map((element) => parseFloat(getComputedStyle(element).fontSize)),
      ),
    );
    expect(smallest).toBeGreaterThanOrEqual(14);
  } finally {
    await page.setViewportSize(wide);
  }
});

test("SWR-CON-022 the theme is the system's, until one is chosen, which is kept", async () => {
  const scheme = (where: Page) =>
    where.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const other = await browser.newContext({ colorScheme: "light" });
  try {
    const tab = await openTab(other);
    const light = await scheme(tab);
    await tab.emulateMedia({ colorScheme: "dark" });
    await expect.poll(() => scheme(tab), within).not.toBe(light);
    await tab.getByLabel("Theme").selectOption("light");
    await expect.poll(() => scheme(tab), within).toBe(light);
    await tab.reload();
    await tab.locator(".theme-choice").waitFor();
    await expect.poll(() => scheme(tab), within).toBe(light);
    await tab.emulateMedia({ forcedColors: "active" });
    await takePictureOf("forced-colours", tab);
  } finally {
    await other.close();
  }
});

test("SWR-CON-023 help opens by its key, keeps the rules, covers no stop, and leads to views", async () => {
  await page.keyboard.press("?");
  await page.getByRole("dialog", { name: "Help" }).waitFor();
  try {
    for (const width of [320, 1440]) {
      await resize(width);
      await expect.poll(() => isStopWhole(), within).toBe(true);
      await expectNoFinding(`help ${width}`);
      await takePictureOf(`help-${width}`);
    }
  } finally {
    await page.setViewportSize(wide);
  }
  await page.getByRole("button", { name: "Show me the page" }).click();
  const tour = page.getByRole("region", { name: "First steps" });
  for (;;) {
    await page.locator("[data-toured]").waitFor({ state: "attached" });
    await expect.poll(() => isStopWhole(), within).toBe(true);
    const next = tour.getByRole("button", { name: /Next|Done/ });
    const isLast = (await next.textContent()) === "Done";
    await next.click();
    if (isLast) {
      break;
    }
  }
  await tour.waitFor({ state: "detached" });
  await page.keyboard.press("g");
  await page.keyboard.press("m");
  await page.locator('.views a[href="#motors"][aria-current]').waitFor();
  await open("procedure");
});

const FIRST_LOAD_BYTES = 130_000;

test("SWR-CON-024 scripts and styles of the first view are small as they are sent", async () => {
  const other = await browser.newContext();
  try {
    const tab = await openTab(other);
    await tab.locator("[data-axis]").first().waitFor();
    const sizes = await tab.evaluate(() =>
      (performance.getEntriesByType("resource") as PerformanceResourceTiming[])
        .filter(({ name }) => /\.(js|css)$/.test(name))
        .map(({ encodedBodySize }) => encodedBodySize),
    );
    expect(sizes.length).toBeGreaterThanOrEqual(2);
    const sum = sizes.reduce((one, another) => one + another, 0);
    expect(sum).toBeGreaterThan(0);
    expect(sum).toBeLessThanOrEqual(FIRST_LOAD_BYTES);
  } finally {
    await other.close();
  }
});

test("SWR-CON-002 what can be pressed is large enough", async () => {
  for (const button of await page.locator("button").all()) {
    const box = await button.boundingBox();
    expect(box?.height).toBeGreaterThanOrEqual(36);
    expect(box?.width).toBeGreaterThanOrEqual(36);
  }
});

test("SWR-HTTP-004 the browser has nothing to complain of and asks nobody else", () => {
  expect(problems).toEqual([]);
  expect([...origins]).toEqual([new URL(url).origin]);
});
