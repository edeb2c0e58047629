// SPDX-License-Identifier: Apache-2.0
// STOP by the console of a running system, from each page and browser, and the command that a page takes and gives up, in a
// real browser. verification/system/punctual/test_console_stop.rb starts the system. The environment that console_page.ts names
// is needed, and:
//   BORESIGHT_LOGIN_CODE  code of the first login
import { type BrowserContext, type Page, type Request } from "playwright-core";
import { expect, test } from "vitest";
import {
  browser,
  chooseTheme,
  context,
  openTab,
  origins,
  page,
  pressStop,
  problems,
  serverPid,
  shareOnePage,
  simulate,
  startUp,
  stopOrigin,
  takePictureOf,
  url,
  variable,
  waitForText,
  workphase,
} from "./console_page";
import { within } from "./opened_page";

const loginCode = variable("BORESIGHT_LOGIN_CODE");
const STREAMS = 8;

shareOnePage();

/** Takes places in the stream until there is none left; returns how to give them back. */
async function fillStreams(): Promise<() => void> {
  const end = new AbortController();
  for (let number = 0; number < STREAMS; number++) {
    const response = await fetch(new URL("/api/v1/events", url), {
      signal: end.signal,
    });
    if (!response.ok) {
      break;
    }
    void response.body?.pipeTo(new WritableStream()).catch(() => undefined);
  }
  return () => end.abort();
}

test("SWR-HTTP-002 the stop button stops and says so", async () => {
  await pressStop();
  await waitForText(".stop-result", "Control has stopped all motion.");
  expect(await workphase()).toBe("STOP");
  await waitForText(".banner-state", "STOP");
});

test("SWR-CON-008 what was stopped is not said to stand when it no longer does", async () => {
  await startUp();
  await waitForText(".stop-result", "A software stop.");
});

test("SWR-HTTP-002 Escape stops from anywhere", async () => {
  await page.reload();
  await waitForText(".banner-next", "Press and hold the pedal.");
  await page.locator(".log").focus();
  await page.keyboard.press("Escape");
  await waitForText(".stop-result", "Control has stopped all motion.");
});

test.each(["Escape", "Enter"])(
  "SWR-CON-010 %s held down asks once",
  async (key) => {
    const requests: string[] = [];
    const note = (one: Request) => {
      if (one.method() !== "GET") {
        requests.push(one.url()); // The page asks meanwhile for the allowed commands.
      }
    };
    page.on("request", note);
    await page.locator(".stop-button").focus();
    for (let repeat = 0; repeat < 30; repeat++) {
      await page.keyboard.down(key);
    }
    await page.keyboard.up(key);
    await expect.poll(() => requests.length, within).toBeGreaterThan(0);
    await waitForText(".stop-result", "Control has stopped all motion.");
    page.off("request", note);
    expect(requests).toEqual([`${stopOrigin.href}api/v1/stop`]);
  },
);

test.each([6, 9])(
  "SWR-CON-006 of %i tabs of one browser each has data, and a stop leaves from the last",
  async (count) => {
    const streams = new Set<Request>();
    context.on("request", (one) => {
      if (one.url().endsWith("/events")) {
        streams.add(one);
      }
    });
    context.on("requestfailed", (one) => streams.delete(one));
    context.on("requestfinished", (one) => streams.delete(one));
    const tabs: Page[] = [];
    try {
      while (tabs.length < count - 1) {
        tabs.push(await openTab());
      }
      for (const tab of [page, ...tabs]) {
        await tab.locator('.panels[data-freshness="live"]').waitFor();
      }
      await startUp();
      simulate("pedal press");
      const last = tabs.at(-1) ?? page;
      await last.locator('[data-axis][data-level="active"]').first().waitFor();
      await pressStop(last);
      for (const tab of [page, ...tabs]) {
        await waitForText(
          ".stop-result",
          "Control has stopped all motion.",
          tab,
        );
      }
      expect(await workphase()).toBe("STOP");
      // It is the shared worker's; a tab has its own no longer than a slow worker has not greeted.
      await expect.poll(() => streams.size, within).toBe(0);
    } finally {
      simulate("pedal release");
      await Promise.all(tabs.map((tab) => tab.close()));
    }
  },
);

test("SWR-CON-011 one console too many is refused in words, and can stop", async () => {
  await startUp();
  const giveBack = await fillStreams();
  const other = await browser.newContext();
  try {
    const ninth = await openTab(other);
    await waitForText(".banner", "Too many consoles are open", ninth);
    await takePictureOf("ninth", ninth);
    await pressStop(ninth);
    await waitForText(".stop-result", "confirmed the stop", ninth);
    expect(await workphase()).toBe("STOP");
    giveBack();
    await ninth.locator('.panels[data-freshness="live"]').waitFor();
    await waitForText(".stop-result", "Control has stopped all motion.", ninth);
  } finally {
    giveBack();
    await other.close();
  }
});

test("SWR-CON-007 a stop that was not confirmed stands across the page until control has stopped", async () => {
  await startUp();
  process.kill(serverPid, "SIGSTOP");
  try {
    await pressStop();
    const alert = page.locator(".stop-failed");
    await alert.waitFor();
    expect(await alert.textContent()).toContain("NOT STOPPED");
    expect((await alert.boundingBox())?.width).toBeGreaterThan(1300);
    await takePictureOf("not-stopped");
    await chooseTheme("light");
    await takePictureOf("not-stopped-light");
    await chooseTheme("dark");
  } finally {
    process.kill(serverPid, "SIGCONT");
  }
  await page.locator('.panels[data-freshness="live"]').waitFor();
  await pressStop();
  // It has arrived, and stops nothing of the next test.
  await waitForText(".stop-result", "Control has stopped all motion.");
  await page.locator(".stop-failed").waitFor({ state: "detached" });
});

test("SWR-CON-009 a browser that refuses storage and workers shows the page and stops", async () => {
  await startUp();
  const other = await browser.newContext();
  await other.addInitScript(() => {
    for (const name of ["localStorage", "SharedWorker"]) {
      Object.defineProperty(window, name, {
        get: () => {
          throw new DOMException("refused", "SecurityError");
        },
      });
    }
  });
  try {
    const tab = await openTab(other);
    await tab.locator('.panels[data-freshness="live"]').waitFor();
    await pressStop(tab);
    await waitForText(".stop-result", "Control has stopped all motion.", tab);
  } finally {
    await other.close();
  }
});

let operatorContext: BrowserContext;
let operator: Page;

function button(name: string, where = operator) {
  return where.getByRole("button", { name, exact: true });
}

test("SWR-SESS-012 a browser logs in, and shows no script its cookie", async () => {
  operatorContext = await browser.newContext();
  operator = await openTab(operatorContext);
  await button("Log in…").click();
  await operator.getByLabel(/Code/).fill(loginCode);
  await button("Log in").click();
  await waitForText(".login", "Logged in as code (engineer)", operator);
  await takePictureOf("logged-in", operator);
  expect(await operator.evaluate(() => document.cookie)).toBe("");
  const [cookie] = await operatorContext.cookies();
  expect(cookie).toMatchObject({
    httpOnly: true,
    sameSite: "Strict",
    path: "/",
  });
  await operator.reload();
  await waitForText(".login", "Logged in as code", operator);
});

test("SWR-CON-012 everybody sees by name who commands", async () => {
  await startUp();
  for (const tab of [page, operator]) {
    await waitForText(
      ".banner-command",
      /Commanded by workphases 127\.0\.0\.1:\d+ for \d+ s/,
      tab,
    );
  }
});

test("SWR-CON-013 everybody sees for whom the button would be pressed", async () => {
  await button("Ask for command").click();
  for (const tab of [page, operator]) {
    await waitForText(
      ".banner-asked",
      /^page .+ asks to command.+ s left$/,
      tab,
    );
  }
  await takePictureOf("asks", operator);
});

test("SWR-CON-014 a page takes command by the button at the box, and keeps it", async () => {
  simulate("button press");
  await waitForText(".login", "This page commands.", operator);
  simulate("button release");
  await waitForText(".banner-command", "Commanded by page");
  await takePictureOf("commands", operator);
  await waitForText(".banner-command", /for ([6-9]|\d\d) s/); // Longer than without a renewal.
});

test("SWR-CON-015 a page that is loaded again has given up", async () => {
  await operator.reload();
  await waitForText(".banner-command", "Nobody commands", operator);
  await button("Take command").waitFor();
});

test("SWR-SESS-012 a browser logs out, and can stop", async () => {
  try {
    await button("Log out").click();
    await waitForText(".login", "Nobody can log in here.", operator);
    expect(await operatorContext.cookies()).toEqual([]);
    await pressStop(operator);
    await waitForText(
      ".stop-result",
      "Control has stopped all motion.",
      operator,
    );
  } finally {
    await operatorContext.close();
  }
});

test("SWR-HTTP-004 the browser has nothing to complain of and asks nobody else", () => {
  expect(problems).toEqual([]);
  expect([...origins]).toEqual([new URL(url).origin, stopOrigin.origin]);
});
