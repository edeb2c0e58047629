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
  /** The next answers at this path. */
  answers: Record<string, { status?: number; body: object }>;
}

export async function makeCommander(role: Role): Promise<Commander> {
  const asked: (Asked & { method: string })[] = [];
  const answers: Commander["answers"] = {
    "/api/v1/session": {
      body: { is_open: true, role, token: "t0ken", login: "none" },
    },
  };
  vi.stubGlobal("fetch", (path: string, options: RequestInit) => {
    const text = typeof options.body === "string" ? options.body : "null";
    const body = JSON.parse(text) as Asked["body"];
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
  return { operation, authority, acts, answers };
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
  const modes = ["JOG", "HOME_AXIS", "RETRACT", "ALIGN", "INSERT", "POSE"];
  return {
    workphases: steps.map((name): Step => ({
      name,
      ...judge(allowed.includes(name)),
    })),
    modes: modes.map((name): Mode => ({
      name,
      command: name,
      workphases: [],
      ...judge(allowed.includes(name)),
    })),
  };
}
