// SPDX-License-Identifier: Apache-2.0
// The console in a real browser over TLS, which verification/system/http/test_http_tls.rb has put in front of a running system.
// Needed from the environment:
//   BORESIGHT_URL        where the console is served; its host is this machine
//   BORESIGHT_AUTHORITY  SHA-256 of the public key of who signed the certificate, base64
//   BORESIGHT_LOGIN      name and password, with a space between them
import {
  chromium,
  type Browser,
  type BrowserContext,
  type Page,
  type Request,
} from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";

const url = new URL(process.env.BORESIGHT_URL ?? "");
const [name = "", password = ""] = (process.env.BORESIGHT_LOGIN ?? "").split(
  " ",
);
const LOGIN_PATH = "/api/v1/session";
const problems: string[] = [];
const requests: Request[] = [];
let browser: Browser;
let context: BrowserContext;
let page: Page;

function text(selector: string, words: string) {
  return page.locator(selector, { hasText: words }).waitFor();
}

beforeAll(async () => {
  browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: [
      "--no-sandbox",
      "--disable-gpu",
      `--host-resolver-rules=MAP ${url.hostname} 127.0.0.1`,
      `--ignore-certificate-errors-spki-list=${process.env.BORESIGHT_AUTHORITY}`,
    ],
  });
  context = await browser.newContext();
  page = await context.newPage();
  page.setDefaultTimeout(120_000);
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("request", (request) => requests.push(request));
  await page.goto(url.href);
});

afterAll(() => browser.close());

test("nothing is shown before somebody logs in", async () => {
  await text(".login", "Not logged in");
  expect(await page.locator("[data-axis]").count()).toBe(0);
});

test("a stop passes without a session", async () => {
  await page.getByRole("button", { name: "STOP MOTION" }).click();
  await text(".stop-result", "Control has confirmed the stop.");
  const stop = requests.find((request) =>
    request.url().endsWith("/api/v1/stop"),
  );
  const asked = new URL(stop?.url() ?? "");
  expect([asked.protocol, asked.hostname]).toEqual(["https:", url.hostname]);
  expect(asked.port).not.toBe(url.port);
});

test("who logs in gets a cookie that stays in TLS, and sees the axes", async () => {
  await page.getByRole("button", { name: "Log in…" }).click();
  await page.getByLabel("Name").fill(name);
  await page.getByLabel("Password").fill(password);
  await page.getByRole("button", { name: "Log in" }).click();
  await text(".login", `Logged in as ${name}`);
  await page.locator("[data-axis]").first().waitFor();
  const cookies = await context.cookies();
  expect(cookies.map(({ path }) => path).sort()).toEqual(["/", LOGIN_PATH]);
  for (const cookie of cookies) {
    expect(cookie).toMatchObject({
      secure: true,
      httpOnly: true,
      sameSite: "Strict",
      domain: url.hostname,
    });
    expect(cookie.name).toMatch(
      cookie.path === "/"
        ? /^__Host-boresight-/
        : /^__Secure-boresight_device-/,
    );
  }
  expect(await page.evaluate(() => document.cookie)).toBe("");
  await page.getByRole("button", { name: "STOP MOTION" }).click();
  await text(".stop-result", "Control has stopped all motion.");
});

test("who logs out is out, and nothing went astray", async () => {
  await page.getByRole("button", { name: "Log out" }).click();
  await text(".login", "Not logged in");
  const left = (await context.cookies()).map(({ path }) => path);
  expect(left).toEqual([LOGIN_PATH]);
  expect(problems).toEqual([]);
  expect(
    requests.filter((request) => new URL(request.url()).protocol !== "https:"),
  ).toEqual([]);
});
