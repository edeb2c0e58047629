// SPDX-License-Identifier: Apache-2.0
// Commands by the names, labels and paths of their rows in core/interface.
import { commands, type Path } from "@interface";

export type CommandName = keyof typeof commands;

const AXIS = "{axis}";

const acts = Object.values(commands)
  .filter(({ method }) => method === "POST")
  .map(({ label, path }) => ({ label, ends: path.split(AXIS) }));

/** Path of a command on one axis. */
export function pathOf(name: CommandName, axis: string): Path {
  return commands[name].path.replace(AXIS, axis) as Path;
}

/** Label of the act that is sent to this path, with the axis that the path names. */
export function labelOf(path: Path): string {
  for (const { label, ends } of acts) {
    const [before = path, after] = ends;
    const isAxis = after !== undefined && path.endsWith(after);
    if (path === before && after === undefined) {
      return label;
    }
    if (isAxis && path.startsWith(before)) {
      return `${label} ${path.slice(before.length, -after.length)}`;
    }
  }
  return path;
}
