// SPDX-License-Identifier: Apache-2.0
// Whether a message of the server is as this page knows it. The tables are made of core/interface, as its types are.
import type { Kind, Shape } from "@interface";

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function isWholeFrom(value: unknown, least: number, most: number): boolean {
  const number = Number.isInteger(value) ? (value as number) : NaN;
  return number >= least && number <= most;
}

function misfitOfMembers(
  value: unknown,
  members: Shape<unknown>["members"],
): string | null {
  if (!isObject(value)) {
    return "";
  }
  for (const name in members) {
    const place = misfitOf(value[name], members[name] as Kind);
    if (place !== null) {
      return `/${name}${place}`;
    }
  }
  return null;
}

function misfitOfList(
  value: unknown,
  kind: Kind,
  length: number | undefined,
): string | null {
  if (!Array.isArray(value) || value.length !== (length ?? value.length)) {
    return "";
  }
  for (let index = 0; index < value.length; index += 1) {
    const place = misfitOf(value[index], kind);
    if (place !== null) {
      return `/${index}${place}`;
    }
  }
  return null;
}

function isPlain(value: unknown, kind: string): boolean {
  return kind === "number" ? Number.isFinite(value) : typeof value === kind;
}

/**
 * Where the value is not of the kind, as a JSON pointer; null where it is. A missing value is undefined. A member that the
 * kind does not know is ignored.
 */
export function misfitOf(value: unknown, kind: Kind): string | null {
  if (typeof kind === "string") {
    return isPlain(value, kind) ? null : "";
  }
  if ("members" in kind) {
    return misfitOfMembers(value, kind.members);
  }
  switch (kind[0]) {
    case "whole":
      return isWholeFrom(value, kind[1], kind[2]) ? null : "";
    case "words":
      return kind[1].includes(value as string) ? null : "";
    case "named":
      return misfitOfMembers(value, { name: kind[1], text: "string" });
    case "list":
      return misfitOfList(value, kind[1], kind[2]);
    case "null":
      return value === null ? null : misfitOf(value, kind[1]);
    case "optional":
      return value === undefined ? null : misfitOf(value, kind[1]);
  }
}

/** A message that is not as this page knows it; says where. */
export class Misfit extends Error {}

type Watcher = (place: string) => void;
const watchers = new Set<Watcher>();

/** Informs of each misfit; returns the function that ends that. */
export function watchMisfits(watcher: Watcher): () => void {
  watchers.add(watcher);
  return () => watchers.delete(watcher);
}

/**
 * The value as this message. Throws a misfit when it is none, and informs the watchers; `name` is that of the message.
 *
 * @satisfies SWR-CON-039
 * @satisfies SWR-CON-045
 */
export function fitted<Message>(
  value: unknown,
  shape: Shape<Message>,
  name: string,
): Message {
  const place = misfitOf(value, shape);
  if (place === null) {
    return value as Message;
  }
  watchers.forEach((send) => send(name + place));
  throw new Misfit(name + place);
}
