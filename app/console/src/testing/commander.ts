// SPDX-License-Identifier: Apache-2.0
// A page that commands, before a server that answers everything and writes down what it was asked.
import { cleanup } from "@testing-library/react";
import { vi } from "vitest";
import {
  modeButtons,
  type Authority,
  type Mode,
  type Modes,
  type Robot,
  type Role,
  type Step,
} from "@interface";
import { Operation } from "../state/operation";
import { makeAuthority, makeSession } from "./robot";

/** Values that a test gives for the robot replace these. */
export const plainRobot: Robot = {
  name: "neuro",
  checksum: "a78c5496",
  slots: 10,
  axes: [],
  poses: [],
};

interface Asked {
  path: string;
  body: Record<string, unknown> | null;
}

export interface Commander {
  operation: Operation;
  /** It is this page that has authority. */
  authority: Authority;
  /** The commands, in their order; questions are left out. */
  acts(): Asked[];
  /** The requests with PUT. */
  puts(): Asked[];
  /** The questions, with their queries. */
  questions(): string[];
  /** The requests with DELETE. */
  deletions(): string[];
  /** The next answers at this path. */
  answers: Record<string, { status?: number; body: object }>;
}

function readBody({ body, headers }: RequestInit): Asked["body"] {
  const text = typeof body === "string" ? body : "null";
  const type = new Headers(headers).get("Content-Type");
  return type === "text/csv" ? { text } : (JSON.parse(text) as Asked["body"]);
}

export async function makeCommander(role: Role): Promise<Commander> {
  const asked: (Asked & { method: string })[] = [];
  const answers: Commander["answers"] = {
    "/api/v1/session": { body: makeSession(role) },
  };
  vi.stubGlobal("fetch", (path: string, options: RequestInit) => {
    const body = readBody(options);
    asked.push({ path, body, method: options.method ?? "GET" });
    const { status = 200, body: reported } = answers[path] ?? { body: {} };
    const answer =
      path === "/api/v1/robot" ? { ...plainRobot, ...reported } : reported;
    return Promise.resolve(new Response(JSON.stringify(answer), { status }));
  });
  const operation = new Operation();
  operation.session.start();
  await vi.waitUntil(() => operation.session.getView().session !== null);
  const authority = makeAuthority({
    state: "held",
    source: "HTTP",
    peer: operation.page.number,
  });
  const by = (wanted: string) => () =>
    asked
      .filter(({ method }) => method === wanted)
      .map(({ path, body }) => ({ path, body }));
  const pathsBy = (wanted: string) => () =>
    by(wanted)().map(({ path }) => path);
  return {
    operation,
    authority,
    acts: by("POST"),
    puts: by("PUT"),
    questions: pathsBy("GET"),
    deletions: pathsBy("DELETE"),
    answers,
  };
}

/** Ends the page, and the server before it. */
export function leave({ operation }: Commander): void {
  operation.session.stop();
  cleanup();
  vi.unstubAllGlobals();
}

const reason = "The present workphase does not allow it.";

export const refusedHere = reason;

/** Acts that move nothing. */
export const plainActs = [
  "REGISTRATION",
  "TARGET",
  "ENTRY",
  "PROBE",
  "MEMBRANES",
  "STEER",
  "CLEAR_AXIS",
  "CONFIRM_AXIS",
  "SET_HOME",
  "ENABLE_AXIS",
  "DISABLE_AXIS",
  "ZERO_FORCE",
] as const;

/** The named workphases, modes and acts are allowed, all others are not. */
export function makeOutlook(...allowed: string[]): Modes {
  const judgement = (name: string) => {
    const isAllowed = allowed.includes(name);
    return {
      is_allowed: isAllowed,
      status: isAllowed ? null : ("WRONG_WORKPHASE" as const),
      reason: isAllowed ? null : reason,
    };
  };
  const names = ["START_UP", "PLANNING", "CALIBRATION", "TARGETING"];
  const steps = [...names, "MOVE_TO_TARGET", "MANUAL", "STOP", "EMERGENCY"];
  const single = ["JOG", "HOME_AXIS", "VELOCITY", "TRAJECTORY", "SWEEP"];
  const modes = [
    "HOMING",
    ...single,
    "POSE",
    "PROGRAM",
    ...Object.keys(modeButtons),
  ];
  return {
    commands: plainActs.map((name) => ({ name, ...judgement(name) })),
    workphases: steps.map((name): Step => ({
      name,
      says: "",
      ...judgement(name),
    })),
    modes: modes.map((name): Mode => ({
      name,
      command: name === "HOMING" ? "WORKPHASE" : name,
      workphases: name === "HOMING" ? ["START_UP"] : ["MANUAL"],
      says: "",
      axes: [],
      ...judgement(name),
    })),
  };
}
