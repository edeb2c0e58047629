// SPDX-License-Identifier: Apache-2.0
// Asking control to stop, by every way there is.
import type { Problem, RobotState } from "@interface";
import { transport } from "@transport";
import type { Freshness } from "./freshness";

/** Without an answer for so long the other way is tried as well. */
export const HEDGE_MS = 300;
export const STOP_TIMEOUT_MS = 1500;
const SILENCE = "The server does not answer.";

export interface StopResult {
  isConfirmed: boolean;
  /** Why not. */
  reason: string;
}

/** The server refused, and said why. */
class Refusal extends Error {}

async function request(address: string, signal: AbortSignal): Promise<void> {
  const response = await transport.request(address, {
    method: "POST",
    body: "{}",
    signal,
  });
  if (!response.ok) {
    const answer = (await response.json()) as Partial<Problem>;
    throw new Refusal(answer.detail ?? response.statusText);
  }
}

/** Resolves after `ms`, or as soon as `before` has failed. */
function hedge(ms: number, before: Promise<void>): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, ms);
    before.catch(() => resolve());
  });
}

async function requestAfter(
  before: Promise<void>,
  address: string,
  signal: AbortSignal,
): Promise<void> {
  await hedge(HEDGE_MS, before);
  signal.throwIfAborted();
  await request(address, signal);
}

/** The first request leaves before this returns. */
function requestAll(addresses: string[], signal: AbortSignal): Promise<void> {
  const tried: Promise<void>[] = [];
  for (const address of addresses) {
    const before = tried.at(-1);
    tried.push(
      before === undefined
        ? request(address, signal)
        : requestAfter(before, address, signal),
    );
  }
  return Promise.any(tried);
}

function reasonOf(failure: unknown): string {
  const reasons: unknown[] =
    failure instanceof AggregateError ? failure.errors : [];
  const refusal = reasons.find((one) => one instanceof Refusal);
  return refusal?.message ?? SILENCE;
}

/** Asks control to stop all motion. Always resolves, and what has not left until then never leaves. */
export async function requestStop(
  addresses = transport.stopAddresses(),
): Promise<StopResult> {
  const abort = new AbortController();
  const timer = setTimeout(() => abort.abort(), STOP_TIMEOUT_MS);
  try {
    await requestAll(addresses, abort.signal);
    return { isConfirmed: true, reason: "" };
  } catch (failure) {
    return { isConfirmed: false, reason: reasonOf(failure) };
  } finally {
    clearTimeout(timer);
    abort.abort();
  }
}

/** Whether control is seen to have stopped; null where the data of this moment does not say: old, none, unreadable. */
export function isSeenStopped(
  freshness: Freshness,
  robot: RobotState | null,
): boolean | null {
  if (freshness !== "live" || robot === null) {
    return null;
  }
  try {
    return (
      robot.status.workphase.name === "STOP" &&
      robot.motors.axes.every((axis) => !axis.is_driven)
    );
  } catch {
    return null; // From a server of another build.
  }
}
