// SPDX-License-Identifier: Apache-2.0
import type { Modes, RobotState } from "@interface";
import type { Commanding, Operation } from "../../state/operation";

/** Properties of the panel of each mode. */
export interface ModePanelProperties {
  robot: RobotState;
  operation: Operation;
  commanding: Commanding;
  outlook: Modes | null;
}
