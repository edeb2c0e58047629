// SPDX-License-Identifier: Apache-2.0
// Rule under test: the result of a command is shown in whichever view the user is by then.
import { act, render, screen, within } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import type { Act, Path } from "@interface";
import { makeCommander, type Commander, leave } from "../testing/commander";
import { RecentActs } from "./RecentActs";

const JOG: Path = "/api/v1/motors/yaw/jog";
let commander: Commander;

/** Begun, one after the other, by panels that are not there any more. */
async function show(...paths: Path[]): Promise<void> {
  commander = await makeCommander("OPERATOR");
  const { page } = commander.operation;
  for (const path of paths) {
    commander.answers[path] = { status: 202, body: { state: "accepted" } };
    await page.act(path, {});
  }
  render(<RecentActs operation={commander.operation} />);
}

function hear(change: Partial<Act>): void {
  const { page } = commander.operation;
  const said = { id: 1, page: page.number, ...change } as Act;
  act(() => page.recentActs.hearAct(said));
}

function reported(): string[] {
  const items = within(screen.getByRole("list")).queryAllByRole("listitem");
  const summary = document.querySelector("summary");
  return [summary, ...items].map((one) => one?.textContent.trim() ?? "");
}

afterEach(() => leave(commander));

test("SWR-CON-046 its place is there before the first command", async () => {
  await show();
  expect(document.body.textContent).toBe("No command from this page yet.");
});

test("SWR-CON-046 who may not command has no such place", async () => {
  commander = await makeCommander("OBSERVER");
  render(<RecentActs operation={commander.operation} />);
  expect(document.body.textContent).toBe("");
});

test("SWR-CON-046 the end of a command is reported after another one was given", async () => {
  await show(JOG, "/api/v1/needle/retract");
  hear({ state: "failed", message: "Discarded before it was done." });
  hear({ id: 2, state: "done" });
  const [last, before] = reported();
  expect(last).toContain("Retract needle: done");
  expect(before).toContain("Jog yaw: not done. Discarded before it was done.");
});

test("SWR-CON-046 of all that have begun the end is unknown once the stream was interrupted", async () => {
  await show(JOG, JOG);
  hear({ state: "done" });
  act(() => commander.operation.page.recentActs.loseActs());
  const [last, before] = reported();
  expect(last).toContain("its end is not known");
  expect(before).toContain("done");
});

test("SWR-CON-046 the last eight are kept", async () => {
  await show(...Array.from({ length: 10 }, () => JOG));
  expect(reported()).toHaveLength(8);
});
