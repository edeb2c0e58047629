// SPDX-License-Identifier: Apache-2.0
// A browser with one page, which notes what the page asks for and what is wrong in it.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { chromium, type Browser, type Page } from "playwright-core";

/** A bound against hanging, and no judgement. */
export const within = { timeout: 120_000 };

export interface OpenedPage {
  browser: Browser;
  page: Page;
  /** Addresses. */
  asked: string[];
  /** Messages of the browser about it: errors, warnings and refusals of its policy. */
  problems: string[];
}

export async function openPage(address: string): Promise<OpenedPage> {
  const browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu"],
  });
  const page = await browser.newPage({
    viewport: { width: 1440, height: 980 },
  });
  const asked: string[] = [];
  const problems: string[] = [];
  page.setDefaultTimeout(within.timeout);
  page.on("request", (request) => asked.push(request.url()));
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) {
      problems.push(message.text());
    }
  });
  await page.goto(address);
  return { browser, page, asked, problems };
}

/** Findings of axe in the page as it stands, a line each. */
export async function findingsOf(page: Page): Promise<string> {
  const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
  await page.evaluate(readFileSync(axe, "utf8"));
  const found: { violations: { id: string; nodes: { html: string }[] }[] } =
    await page.evaluate("axe.run({ resultTypes: ['violations'] })");
  return found.violations
    .flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html}`))
    .join("\n");
}
