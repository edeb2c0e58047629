// SPDX-License-Identifier: Apache-2.0
// Rule under test: what is drawn is the last 30 s of control's time, with gaps where nothing came.
import { expect, test } from "vitest";
import type { Axis } from "@interface";
import { makeAxis, makeRobot } from "../testing/robot";
import { Trace } from "./trace";

const STEP_US = 50_000;
const WRAP = 2 ** 32;

/** Feeds a trace a state each 50 ms. */
class Feed {
  readonly trace = new Trace();
  timeUs = 1_000_000;
  nowMs = 0;
  bootId = "one";

  take(change: Partial<Axis> = {}): void {
    const robot = makeRobot({ boot_id: this.bootId }, [
      makeAxis("head", change),
    ]);
    robot.motors.time_us = this.timeUs % WRAP;
    this.trace.take(robot, this.nowMs);
  }

  go(times = 1, change: Partial<Axis> = {}): void {
    for (let time = 0; time < times; time += 1) {
      this.timeUs += STEP_US;
      this.nowMs += STEP_US / 1000;
      this.take(change);
    }
  }
}

test("SWR-CON-027 keeps 30 s and no more", () => {
  const feed = new Feed();
  feed.go(1000);
  const times = feed.trace.times();
  expect(times).toHaveLength(601);
  expect(times[0]).toBeCloseTo(-30);
  expect(times.at(-1)).toBe(0);
});

test("SWR-CON-027 goes by control's time, over its wrap", () => {
  const feed = new Feed();
  feed.timeUs = WRAP - STEP_US;
  feed.take();
  feed.go(2);
  const times = feed.trace.times();
  expect(times).toHaveLength(3);
  expect(times[0]).toBeCloseTo(-0.1);
});

test("SWR-CON-027 has the set-point, position, speed and output of each axis", () => {
  const feed = new Feed();
  feed.go(1, { setpoint: 2, position: 1, speed_per_s: 3, output_percent: -4 });
  const { trace } = feed;
  expect(trace.column("head", "setpoint")).toEqual([2]);
  expect(trace.column("head", "position")).toEqual([1]);
  expect(trace.column("head", "speed")).toEqual([3]);
  expect(trace.column("head", "output")).toEqual([-4]);
  expect(trace.column("other", "output")).toEqual([null]);
});

test("SWR-CON-027 leaves a gap where the data was stale", () => {
  const feed = new Feed();
  feed.go(2);
  feed.timeUs += 1_000_000;
  feed.nowMs += 1000;
  feed.go();
  expect(feed.trace.column("head", "position")).toEqual([10, 10, null, 10]);
});

test("SWR-CON-027 takes nothing while control stands still, and has a gap after it", () => {
  const feed = new Feed();
  feed.go();
  const { revision } = feed.trace;
  for (let time = 0; time < 20; time += 1) {
    feed.nowMs += 50;
    feed.take();
  }
  expect(feed.trace.revision).toBe(revision);
  feed.go();
  expect(feed.trace.column("head", "position")).toEqual([10, null, 10]);
});

test("SWR-CON-027 forgets another run", () => {
  const feed = new Feed();
  feed.go(5);
  feed.bootId = "two";
  feed.go();
  expect(feed.trace.times()).toEqual([0]);
});

test("SWR-CON-027 draws no way from a position that was only counted to one that is known", () => {
  const feed = new Feed();
  feed.go(1, { reference: "approach", position: 20 });
  expect(feed.trace.column("head", "position")).toEqual([20]);
  feed.go(1, { reference: "verified", position: 0 });
  expect(feed.trace.column("head", "position")).toEqual([null, 0]);
  expect(feed.trace.column("head", "speed")).toEqual([1, 1]);
});

test("SWR-CON-027 reads what was nearest to a time", () => {
  const feed = new Feed();
  feed.go(1, { position: 1 });
  feed.go(1, { position: 2 });
  expect(feed.trace.at("head", 0.04)?.position).toBe(1);
  expect(feed.trace.at("head", 0)?.position).toBe(2);
  expect(feed.trace.at("other", 0)).toBeNull();
  expect(new Trace().at("head", 0)).toBeNull();
});

test("SWR-CON-027 a copy stands while the trace goes on", () => {
  const feed = new Feed();
  feed.go(2);
  const copy = feed.trace.copy();
  feed.go(3);
  expect(copy.times()).toHaveLength(2);
  expect(feed.trace.times()).toHaveLength(5);
});

test("SWR-CON-027 a file has names with units, and no row for a gap", () => {
  const feed = new Feed();
  feed.go(1, { setpoint: -0.5 });
  feed.timeUs += 1_000_000;
  feed.nowMs += 1000;
  feed.go();
  expect(feed.trace.csv([{ name: "head", unit: "deg" }])).toBe(
    "time s,head set-point deg,head position deg,head speed deg/s,head output %,head goal deg\n" +
      "0.000,-0.5,10,1,0,20\n" +
      "1.050,12.5,10,1,0,20\n",
  );
});
