// SPDX-License-Identifier: Apache-2.0
import type { Modes, RobotState } from "@interface";
import type { Operation } from "../state/operation";
import type { ConsoleView } from "../state/store";
import type { Trace } from "../words/trace";

/** What each view is given. */
export interface ViewProperties {
  view: ConsoleView;
  robot: RobotState;
  operation: Operation;
  /** What may be commanded now, as the server says it; null while it is not known. */
  outlook: Modes | null;
  /** What the axes have done lately. */
  trace: Trace;
}
