// SPDX-License-Identifier: Apache-2.0
// A page that commands, before a server that answers everything and writes down what it was asked.
import { vi } from "vitest";
import type { Authority, Mode, Modes, Role, Step } from "@interface";
import { Operation } from "../operation";
import { makeAuthority } from "./robot";

interface Asked {
  path: string;
  body: Record<string, unknown> | null;
}

export interface Commander {
  operation: Operation;
  /** It is this page that has authority. */
  authority: Authority;
  /** What was commanded, in its order; questions are left out. */
  acts(): Asked[];
  /** What was deleted. */
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
    "/api/v1/session": {
      body: { is_open: true, role, token: "t0ken", login: "none" },
    },
  };
  vi.stubGlobal("fetch", (path: string, options: RequestInit) => {
    const body = readBody(options);
    asked.push({ path, body, method: options.method ?? "GET" });
    const { status = 200, body: answer } = answers[path] ?? { body: {} };
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
  const acts = () =>
    asked
      .filter(({ method }) => method === "POST")
      .map(({ path, body }) => ({ path, body }));
  const deletions = () =>
    asked.filter(({ method }) => method === "DELETE").map(({ path }) => path);
  return { operation, authority, acts, deletions, answers };
}

const reason = "The present workphase does not allow it.";

function judge(isAllowed: boolean) {
  return {
    says: "",
    is_allowed: isAllowed,
    status: isAllowed ? null : "WRONG_WORKPHASE",
    reason: isAllowed ? null : reason,
  };
}

export const refusedHere = reason;

/** Of these workphases and modes all are allowed that are named. */
export function makeOutlook(...allowed: string[]): Modes {
  const names = ["START_UP", "PLANNING", "CALIBRATION", "TARGETING"];
  const steps = [...names, "MOVE_TO_TARGET", "MANUAL", "STOP", "EMERGENCY"];
  const single = ["JOG", "HOME_AXIS", "VELOCITY", "TRAJECTORY", "SWEEP"];
  const modes = [
    "HOMING",
    ...single,
    "RETRACT",
    "ALIGN",
    "INSERT",
    "POSE",
    "PROGRAM",
  ];
  return {
    workphases: steps.map((name): Step => ({
      name,
      ...judge(allowed.includes(name)),
    })),
    modes: modes.map((name): Mode => ({
      name,
      command: name === "HOMING" ? "WORKPHASE" : name,
      workphases: name === "HOMING" ? ["START_UP"] : ["MANUAL"],
      ...judge(allowed.includes(name)),
    })),
  };
}
