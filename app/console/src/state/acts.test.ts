// SPDX-License-Identifier: Apache-2.0
// Rule under test: what became of the last act of this page is shown, from the first source that reports it, and never the result of other acts.
import { afterEach, expect, test, vi } from "vitest";
import type { Act } from "@interface";
import { RecentActs } from "./acts";
import { TelemetryStore } from "./store";
import { makeCommander } from "../testing/commander";
import { FakeSurroundings } from "../testing/surroundings";

const PAGE = 7;

function makeAct(change: Partial<Act> = {}): Act {
  return {
    id: 1,
    page: PAGE,
    state: "done",
    code: "OK",
    message: "Done as asked.",
    axis: null,
    limit: null,
    workphase: "MANUAL",
    ...change,
  };
}

const failure = makeAct({
  state: "failed",
  code: "AXIS_LIMIT",
  message: "An axis would leave its soft limits.",
  axis: "yaw",
  limit: "lower",
});

function begun(): RecentActs {
  const acts = new RecentActs(PAGE);
  acts.begin(1, "/api/v1/velocity", {});
  return acts;
}

afterEach(() => vi.unstubAllGlobals());

test("SWR-CON-033 an act is sent, accepted, and done", () => {
  const acts = begun();
  const states = [acts.getOutcome()?.state];
  acts.subscribe(() => states.push(acts.getOutcome()?.state));
  acts.answer(1, "accepted");
  acts.hearAct(makeAct());
  expect(states).toEqual(["sent", "accepted", "done"]);
});

test("SWR-CON-033 an act that failed later says why, with axis and limit", () => {
  const acts = begun();
  acts.answer(1, "accepted");
  acts.hearAct(failure);
  expect(acts.getOutcome()).toMatchObject({
    state: "failed",
    reason: "An axis would leave its soft limits. (yaw, lower limit)",
  });
});

test("SWR-CON-033 an answer that comes after the end takes nothing back", () => {
  const acts = begun();
  acts.hearAct(failure);
  acts.answer(1, "accepted");
  expect(acts.getOutcome()?.state).toBe("failed");
});

test("SWR-CON-033 what is reported of another page or an earlier act is not this one's", () => {
  const acts = begun();
  acts.begin(2, "/api/v1/align", {});
  acts.hearAct(makeAct({ id: 2, page: PAGE + 1 }));
  acts.hearAct(makeAct());
  acts.answer(1, "done");
  acts.fail(1, "Too late.");
  expect(acts.getOutcome()).toMatchObject({ id: 2, state: "sent" });
});

test("SWR-CON-033 an interrupted stream leaves the end of what was begun unknown", () => {
  const surroundings = new FakeSurroundings();
  const store = new TelemetryStore(surroundings);
  const acts = begun();
  store.tellActsTo(acts);
  store.start();
  acts.answer(1, "accepted");
  surroundings.stream.fail();
  expect(acts.getOutcome()?.state).toBe("lost");
  store.stop();
});

test("SWR-CON-033 the stream reports it, until nobody listens", () => {
  const surroundings = new FakeSurroundings();
  const store = new TelemetryStore(surroundings);
  const acts = begun();
  const stop = store.tellActsTo(acts);
  store.start();
  surroundings.stream.send("act", makeAct({ state: "accepted" }));
  expect(acts.getOutcome()?.state).toBe("accepted");
  stop();
  surroundings.stream.send("act", makeAct());
  expect(acts.getOutcome()?.state).toBe("accepted");
  store.stop();
});

test.each([
  [{ body: { state: "accepted" } }, "accepted", null],
  [{ body: { state: "done" } }, "done", null],
  [
    { status: 409, body: { detail: "No.", axis: "yaw" } },
    "failed",
    "No. (yaw)",
  ],
])("SWR-CON-033 the answer %j reports it", async (answer, state, reason) => {
  const { operation, answers } = await makeCommander("OPERATOR");
  answers["/api/v1/align"] = answer;
  expect(await operation.page.act("/api/v1/align", {})).toBe(reason);
  expect(operation.page.recentActs.getOutcome()).toMatchObject({
    state,
    reason,
  });
  operation.session.stop();
});
