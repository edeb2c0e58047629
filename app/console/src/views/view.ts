// SPDX-License-Identifier: Apache-2.0
import type { Modes, RobotState } from "@interface";
import type { Operation } from "../state/operation";
import type { ConsoleView } from "../state/store";
import type { Trace } from "../words/trace";

/** Properties of each view. */
export interface ViewProperties {
  view: ConsoleView;
  robot: RobotState;
  operation: Operation;
  /** Commands that are allowed now, as the server reports them; null while they are not known. */
  outlook: Modes | null;
  /** The last motions of the axes. */
  trace: Trace;
}
