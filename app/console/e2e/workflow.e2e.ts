// SPDX-License-Identifier: Apache-2.0
// Whole procedures by what a user sees and presses, the pedal by the drawer of the simulated box, on the running system
// of verification/system/punctual/test_console_workflow.rb. The parts go on from one another. Needed from the environment:
//   BORESIGHT_URL        where the console is served
//   BORESIGHT_ROBOT      which robot it is
//   BORESIGHT_ENGINEER, BORESIGHT_OPERATOR  name and password, with a space between them
//   BORESIGHT_HTTP_PID   process of the server
//   BORESIGHT_PICTURES   optional: folder for the pictures of the manual, and for the frames of the moving one
import { mkdirSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { chromium, type Browser, type Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, expect, test } from "vitest";
import type { Motors, Targeting } from "@interface";

const url = process.env.BORESIGHT_URL ?? "";
const robot = process.env.BORESIGHT_ROBOT === "prostate" ? "prostate" : "neuro";
const serverPid = Number(process.env.BORESIGHT_HTTP_PID);
const pictures = process.env.BORESIGHT_PICTURES;
/** A bound against hanging, and no judgement. */
const within = { timeout: 120_000 };
const FRAME_MS = 700;
const DRAWN_PX = 2;
const REACHED_MM = 0.5;
const NEAR_MM = 12;
const window1440 = {
  width: 1440,
  height: pictures === undefined ? 1080 : 1320,
};

const registration = "1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1";
const plans = {
  neuro: { entry: [0, 246, 50], target: [0, 200, 50] },
  prostate: { entry: [-38.3, -35.8, 24.3], target: [-38.3, -45.8, 99.3] },
};
const { entry, target } = plans[robot];

let browser: Browser;
/** Page of the engineer, who does the procedure. */
let page: Page;

async function read<Answer>(name: string): Promise<Answer> {
  const response = await fetch(new URL(`/api/v1/${name}`, url));
  return (await response.json()) as Answer;
}

async function openPage(): Promise<Page> {
  const context = await browser.newContext({ viewport: window1440 });
  const one = await context.newPage();
  one.setDefaultTimeout(within.timeout);
  await one.goto(url);
  await one.locator('.panels[data-freshness="live"]').waitFor();
  return one;
}

function press(label: string | RegExp, where = page) {
  return where.getByRole("button", { name: label, exact: true }).click();
}

function said(text: string | RegExp, where = page) {
  return where.getByText(text).first().waitFor();
}

async function logIn(who: string, where = page): Promise<void> {
  const [name = "", password = ""] = (process.env[who] ?? "").split(" ");
  await press("Log in…", where);
  await where.getByLabel("Name", { exact: true }).fill(name);
  await where.getByLabel("Password").fill(password);
  await press("Log in", where);
  await said(`Logged in as ${name}`, where);
}

async function openBox(where = page): Promise<void> {
  await press("Open the simulated box", where);
  await where.getByRole("button", { name: "Hold pedal" }).waitFor();
}

/** The switch by which the drawer keeps a handle pressed. */
function keeper(handle: "pedal" | "button", where = page) {
  return where.getByRole("switch", { name: `Keep ${handle} pressed` });
}

const LOOK_MS = 300;

async function isKept(handle: "pedal" | "button", where = page) {
  const checked = await keeper(handle, where).getAttribute("aria-checked");
  return checked === "true";
}

/** Pressed anew where the box has let go, in a pause of the machine, before it was seen as kept. */
async function keep(handle: "pedal" | "button", where = page): Promise<void> {
  const kept = where
    .getByRole("group", { name: handle === "pedal" ? "Pedal" : "Button" })
    .getByText("kept by this page");
  while (!(await kept.isVisible())) {
    if (!(await isKept(handle, where))) {
      await keeper(handle, where).and(where.locator(":enabled")).click();
    }
    await where.waitForTimeout(LOOK_MS);
  }
}

async function letGo(handle: "pedal" | "button", where = page): Promise<void> {
  await keeper(handle, where).click();
  await where
    .getByRole("group", { name: handle === "pedal" ? "Pedal" : "Button" })
    .getByText("released")
    .waitFor();
}

/** Keeps the pedal pressed until the end: a box that was let go while the machine paused is pressed anew. */
async function keepPedalUntil(end: Promise<void>): Promise<void> {
  let isOver = false;
  const over = end.finally(() => {
    isOver = true;
  });
  over.catch(() => undefined); // It is awaited below.
  while (!isOver) {
    if (!(await isKept("pedal"))) {
      await keep("pedal");
    }
    await Promise.race([over, page.waitForTimeout(LOOK_MS)]);
  }
  await over;
  if (await isKept("pedal")) {
    await letGo("pedal");
  }
}

function openView(title: string) {
  return page
    .getByRole("navigation", { name: "Views" })
    .getByRole("link", { name: title })
    .click();
}

function panel(title: string) {
  return page.getByRole("region", { name: title, exact: true });
}

/** Presses a step once the server allows it. */
async function enter(phase: string): Promise<void> {
  await panel("Procedure").getByRole("button", { name: phase }).click();
}

async function entered(phase: string): Promise<void> {
  await enter(phase);
  await page.locator(".banner-state strong", { hasText: phase }).waitFor();
}

function picture(name: string): Promise<unknown> {
  return pictures === undefined
    ? Promise.resolve()
    : page.screenshot({ path: `${pictures}/${name}.png` });
}

/** Frames of the moving picture, one after another, while `work` is done. */
let frameCount = 0;
async function filmed(work: () => Promise<void>): Promise<void> {
  if (pictures === undefined) {
    return work();
  }
  let isDone = false;
  const filming = (async () => {
    while (!isDone) {
      const number = String(frameCount++).padStart(3, "0");
      await page.screenshot({ path: `${pictures}/frames/${number}.png` });
      await page.waitForTimeout(FRAME_MS);
    }
  })();
  try {
    await work();
  } finally {
    isDone = true;
    await filming;
  }
}

beforeAll(async () => {
  if (pictures !== undefined) {
    mkdirSync(`${pictures}/frames`, { recursive: true });
  }
  browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu"],
  });
  page = await openPage();
});

afterAll(() => browser.close());

/** A part that failed also says what the page showed then. */
afterEach(async ({ task }) => {
  const [error] = task.result?.errors ?? [];
  if (error !== undefined) {
    const shown = await page.locator(".banner").allInnerTexts();
    const seen = shown.join(" ").replaceAll(/\s+/g, " ");
    error.stack = `The page shows: ${seen}\n${error.stack ?? error.message}`;
  }
});

/** The panel reports that its last command is done. */
function done(what: string, where = "Procedure") {
  return panel(where).getByText(`Last command: ${what}: done.`).waitFor();
}

async function takeCommand(where = page): Promise<void> {
  await press("Take command", where);
  await said("This page commands.", where);
}

async function home(): Promise<void> {
  await enter("START UP");
  await said("Press and hold the pedal.");
  const moved = page.locator(".sign-word", { hasText: "MOVING" }).waitFor();
  await keepPedalUntil(moved.then(() => done("Workphase START UP")));
}

async function plan(): Promise<void> {
  await entered("PLANNING");
  await entered("CALIBRATION");
  await page.getByLabel("Scanner from z-frame").fill(registration);
  await press("Register");
  await panel("Targeting").getByText("accepted").waitFor();
  await entered("TARGETING");
  await page.getByLabel("Entry point, scanner").fill(entry.join(" "));
  await press("Send entry");
  await said("(decides the depth)");
  await page.getByLabel("Target point, scanner").fill(target.join(" "));
  await panel("Aim").getByText("Reachable;").waitFor();
  await press("Send target");
  await panel("Drawing").locator('[data-mark="target"]').first().waitFor();
}

/** Where a mark stands in the drawing from the side, in its pixels. */
async function markAt(mark: "treatment" | "target"): Promise<number[]> {
  const drawn = panel("Drawing").locator(`[data-mark="${mark}"]`).first();
  const place = await drawn.getAttribute("transform");
  return (place?.match(/-?[\d.]+/g) ?? []).map(Number);
}

function distanceBetween(one: number[], another: number[]): number {
  return Math.hypot(...one.map((value, i) => value - (another[i] ?? NaN)));
}

/** Shortly before the needle is there, for the manual. */
async function picturesOfMove(): Promise<void> {
  if (pictures === undefined) {
    return;
  }
  await panel("Drawing").evaluate((one) =>
    one.scrollIntoView({ block: "center" }),
  );
  await expect
    .poll(async () => (await read<Targeting>("targeting")).distance_mm, {
      ...within,
      interval: 50,
    })
    .toBeLessThan(NEAR_MM);
  await picture("console");
}

async function moveToTarget(): Promise<void> {
  await enter("MOVE TO TARGET");
  await said("Press and hold the pedal.");
  await keepPedalUntil(
    picturesOfMove().then(() => done("Workphase MOVE TO TARGET")),
  );
  await said("Nothing; the target is reached.");
}

test("SWR-CON-042 a needle goes to its target with nothing but the browser", async () => {
  await logIn("BORESIGHT_ENGINEER");
  await takeCommand();
  await openBox();
  await filmed(async () => {
    await home();
    await plan();
    await moveToTarget();
  });
  const drawn = await Promise.all([markAt("treatment"), markAt("target")]);
  expect(drawn[0]).toHaveLength(2);
  expect(distanceBetween(drawn[0], drawn[1])).toBeLessThan(DRAWN_PX);
  const { scanner_treatment: pose } = await read<Targeting>("targeting");
  const reached = [3, 7, 11].map((index) => pose?.[index] ?? NaN);
  expect(distanceBetween(reached, target)).toBeLessThan(REACHED_MM);
});

function axis(name: string) {
  return page.locator(`[data-axis="${name}"]`);
}

async function positionOf(name: string): Promise<number> {
  const { axes } = await read<Motors>("motors");
  return axes.find((one) => one.name === name)?.position ?? NaN;
}

/** Takes the circle so many pixels to the right, and lets it go. */
async function drag(name: string, way: number): Promise<void> {
  const grip = axis(name).locator(".slider-grip");
  await grip.evaluate((one) => one.scrollIntoView({ block: "center" }));
  const box = await grip.boundingBox();
  const x = (box?.x ?? NaN) + (box?.width ?? NaN) / 2;
  const y = (box?.y ?? NaN) + (box?.height ?? NaN) / 2;
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + way / 2, y);
  await page.mouse.move(x + way, y);
  await page.mouse.up();
}

/** Not the needle: it is in. */
const dragged = "lateral";
const cleared = "yaw";

test("SWR-CON-028 positions are saved, changed, and restored from the file", async () => {
  await entered("MANUAL");
  await openView("Motors");
  const [saved] = await Promise.all([
    page.waitForEvent("download"),
    press("Save positions"),
  ]);
  expect(saved.suggestedFilename()).toMatch(/^positions-.+\.json$/);

  await press("Retract needle");
  await keepPedalUntil(done("Retract needle", "Needle and poses"));

  const before = await positionOf(dragged);
  await drag(dragged, 60);
  await said("Press and hold the pedal.");
  await keepPedalUntil(done(`Jog ${dragged}`, "Motors"));
  expect(Math.abs((await positionOf(dragged)) - before)).toBeGreaterThan(1);

  await axis(cleared).getByText("Reference").click();
  await axis(cleared).getByRole("button", { name: "Clear position…" }).click();
  await axis(cleared).getByRole("button", { name: "Clear position" }).click();
  await axis(cleared).getByText("unknown").first().waitFor();

  await page.getByLabel("Restore from a file…").setInputFiles({
    name: saved.suggestedFilename(),
    mimeType: "application/json",
    buffer: await readFile(await saved.path()),
  });
  const differences = panel("Saved positions").getByRole("row");
  await differences
    .filter({ hasText: cleared })
    .filter({ hasText: "restored" })
    .waitFor();
  await differences
    .filter({ hasText: dragged })
    .filter({ hasText: "Its counter has moved since." })
    .waitFor();
  await press("Apply…");
  await press("Apply");
  await said("Restored and unverified");
  await keep("button");
  await page
    .locator(`[data-axis="${cleared}"][data-reference="verified"]`)
    .waitFor();
  await letGo("button");
  await openView("Procedure");
});

test("SWR-CON-014 command passes to another browser by the button at the box", async () => {
  const other = await openPage();
  await logIn("BORESIGHT_OPERATOR", other);
  await press("Ask for command", other);
  for (const one of [page, other]) {
    await said(/^page .+ asks to command/, one);
  }
  await keep("button");
  await said("This page commands.", other);
  await letGo("button");
  await page.getByRole("button", { name: "Ask for command" }).waitFor();
  await said("Commanded by page of anna");
  await said("Command lost: another took it by the button at the box.");
  await press("Read");
  await press("Give up command", other);
  await other.context().close();
  await takeCommand();
});

test("SWR-HTTP-002 a page of nobody stops what another one moves", async () => {
  const observer = await openPage();
  await openView("Motors");
  await drag(dragged, -200);
  await said("Press and hold the pedal.");
  const stopped = async () => {
    await observer.locator(".sign-word", { hasText: "MOVING" }).waitFor();
    await said("Not logged in", observer);
    await press(/^STOP MOTION/, observer);
    await said("Control has stopped all motion.", observer);
    await page.locator(".banner-state strong", { hasText: "STOP" }).waitFor();
    const { axes } = await read<Motors>("motors");
    expect(axes.filter((one) => one.is_driven)).toEqual([]);
  };
  await keepPedalUntil(stopped());
  await observer.context().close();
  await openView("Procedure");
});

test.runIf(pictures !== undefined)("pictures of the views", async () => {
  await press("Close the simulated box");
  await page.setViewportSize({ ...window1440, height: 1080 });
  for (const title of ["Motors", "Modes", "Status", "Charts"]) {
    await openView(title);
    await page.locator(".panels .panel").first().waitFor();
    if (title === "Motors") {
      await panel("Plots").getByLabel(dragged).check();
      await panel("Plots").evaluate((one) => one.scrollIntoView());
    } else if (title === "Charts") {
      await press("Show the whole drawing");
    } else {
      await page.evaluate(() => scrollTo(0, 0));
    }
    await page.waitForTimeout(FRAME_MS); // Parts that are loaded late are drawn.
    await picture(title.toLowerCase());
  }
  await openView("Procedure");
});

/** As a server of another build greets. */
async function strangeHello(): Promise<string> {
  const end = new AbortController();
  const { body } = await fetch(new URL("/api/v1/events", url), {
    signal: end.signal,
  });
  const reader = body?.pipeThrough(new TextDecoderStream()).getReader();
  let text = "";
  while (!/event: ?hello\n[^]*?\n\n/.test(text)) {
    const chunk = await reader?.read();
    if (chunk?.value === undefined) {
      throw new Error("the stream has ended");
    }
    text += chunk.value;
  }
  end.abort();
  return text.replace(/"build_id":"[^"]*"/, '"build_id":"another"');
}

/** Its stream is its own, so that it can be put in another's place once it was lost. */
async function openOldPage(): Promise<Page> {
  const context = await browser.newContext();
  await context.addInitScript("delete window.SharedWorker");
  const one = await context.newPage();
  one.setDefaultTimeout(within.timeout);
  await one.goto(url);
  await one.locator('.panels[data-freshness="live"]').waitFor();
  await one.route("**/api/v1/events", async (route) => {
    try {
      const body = await strangeHello();
      await route.fulfill({ contentType: "text/event-stream", body });
    } catch {
      await route.abort(); // There is no server yet.
    }
  });
  return one;
}

test("SWR-CON-043 a page whose server begins anew goes on, or asks to be loaded again if it is of another build", async () => {
  const old = await openOldPage();
  const notice = "The server has been updated. Reload this page.";
  const stale = page.locator(".banner", { hasText: "DATA STALE" }).waitFor();
  process.kill(serverPid, "SIGSTOP"); // So that no page is too slow to see it.
  await stale;
  process.kill(serverPid, "SIGKILL");
  await said(notice, old);
  await page.locator('.panels[data-freshness="live"]').waitFor();
  expect(await page.getByText(notice).count()).toBe(0);
});

test("SWR-SESS-035 a page says why its session has not outlived its server", async () => {
  await said("Command lost: the server was started anew.");
  await said("Logged out: the server was started anew");
  await press("Read");
  await said("Not logged in");
  expect(await page.getByText("Logged out:").count()).toBe(0);
});
