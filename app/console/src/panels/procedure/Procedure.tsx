// SPDX-License-Identifier: Apache-2.0
import {
  commands,
  type Modes,
  type NextWorkphaseRequest,
  type Status,
  type Step,
} from "@interface";
import { words } from "../../words/format";
import {
  useCommanding,
  type Commanding,
  type Operation,
} from "../../state/operation";
import { Order, OrderNotes } from "../../parts/Order";
import { Progress } from "../../parts/drawn/Progress";

type Workphase = NextWorkphaseRequest["workphase"];

/** As a procedure goes; the last one is beside it. */
const order: readonly Workphase[] = [
  "START_UP",
  "PLANNING",
  "CALIBRATION",
  "TARGETING",
  "MOVE_TO_TARGET",
  "MANUAL",
];

function StepItem({
  step,
  isCurrent,
  commanding,
}: {
  step: Step;
  isCurrent: boolean;
  commanding: Commanding;
}) {
  return (
    <li className="step" data-current={isCurrent}>
      <Order
        commanding={commanding}
        path={commands.WORKPHASE.path}
        fields={{ workphase: step.name }}
        refusal={step.reason}
        isCurrent={isCurrent}
      >
        {words(step.name)}
      </Order>
    </li>
  );
}

/** Axes without a switch have lost their positions; the operator has looked, and says so with the button at the box. */
function Confirmation({ commanding }: { commanding: Commanding }) {
  return (
    <Order
      commanding={commanding}
      path={commands.REQUEST.path}
      fields={{ what: "CONFIRM" }}
    >
      Confirm the positions shown…
    </Order>
  );
}

/**
 * The workphases as steps; those that the server would refuse cannot be pressed.
 *
 * @satisfies SWR-CON-016
 */
export function Procedure({
  status,
  outlook,
  operation,
}: {
  status: Status;
  outlook: Modes | null;
  operation: Operation;
}) {
  const commanding = useCommanding(operation, status.authority);
  const steps = order.flatMap(
    (name) => outlook?.workphases.filter((step) => step.name === name) ?? [],
  );
  const isConfirmationDue = steps.some(
    ({ status }) => status === "CONFIRM_POSITIONS",
  );
  return (
    <>
      <OrderNotes commanding={commanding} />
      <ol className="steps">
        {steps.map((step) => (
          <StepItem
            key={step.name}
            step={step}
            isCurrent={step.name === status.workphase.name}
            commanding={commanding}
          />
        ))}
      </ol>
      {isConfirmationDue && <Confirmation commanding={commanding} />}
      <Progress status={status} />
    </>
  );
}
