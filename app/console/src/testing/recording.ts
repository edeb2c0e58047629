// SPDX-License-Identifier: Apache-2.0
import type { RecordingDocument } from "../replay/recording";
import { makeAxis, makeBlockedAxis, makeEntry, makeRobot } from "./robot";

export const released = {
  name: "PEDAL_RELEASED",
  text: "The pedal is released.",
} as const;

export function reported(timeS: number, isDriven: boolean, mode: string) {
  const axis = isDriven
    ? makeAxis("head", { is_driven: true })
    : makeBlockedAxis("head", released);
  const state = makeRobot({}, [axis]);
  state.motors.time_us = timeS * 1e6;
  return {
    time_s: timeS,
    state,
    frames: [null, { drive_mode: mode, guard: 5 }],
  };
}

export function makeDocument(
  change: Partial<RecordingDocument["recording"]> = {},
): RecordingDocument {
  return {
    format: 2,
    numbers_each: 50,
    robot: {
      name: "neuro",
      checksum: "0",
      slots: 2,
      axes: [],
      poses: [],
    },
    rows: [
      [100, 0, reported(0, false, "OFF")],
      [50, 0, reported(0.05, true, "PWM")],
      [50, 0, reported(0.1, false, "OFF")],
    ],
    events: [
      makeEntry(1, { cycle: 150, text: "It begins." }),
      makeEntry(2, { cycle: 200, text: "</script> released." }),
    ],
    recording: {
      build: "1234",
      replayed_by: "5678",
      robot: "neuro",
      checksum: "0",
      started: "2026-11-22T17:50:00.000Z",
      run: "20261122T174959.123456Z",
      first: 0,
      cycles: 201,
      has_run_end: true,
      is_whole_run: true,
      missing: 0,
      replayed: 201,
      unreplayed: 0,
      cycles_lost: 0,
      is_cut_short: false,
      is_trusted: true,
      difference: "",
      ...change,
    },
  };
}
