// SPDX-License-Identifier: Apache-2.0
import type { Modes, RobotState } from "@interface";
import type { Commanding, Operation } from "../../state/operation";

/** What the panel of each mode is given. */
export interface ModePanelProperties {
  robot: RobotState;
  operation: Operation;
  commanding: Commanding;
  outlook: Modes | null;
}
