// SPDX-License-Identifier: Apache-2.0
// Rule under test: what became of a command stands at its button and in words, and nowhere else.
import {
  act,
  fireEvent,
  render,
  screen,
  waitFor,
} from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import type { Act, Authority } from "@interface";
import { useCommanding, type Operation } from "../state/operation";
import { makeCommander, type Commander, leave } from "../testing/commander";
import { Order, OrderNotes } from "./Order";

let commander: Commander;

function PanelOf({
  operation,
  authority,
}: {
  operation: Operation;
  authority: Authority;
}) {
  const commanding = useCommanding(operation, authority);
  return (
    <section>
      <OrderNotes commanding={commanding} />
      <Order commanding={commanding} path="/api/v1/motors/yaw/home">
        Home yaw
      </Order>
      {["PARK", "EGRESS"].map((pose) => (
        <Order
          key={pose}
          commanding={commanding}
          path="/api/v1/pose"
          fields={{ pose }}
        >
          {pose}
        </Order>
      ))}
    </section>
  );
}

function marks(): (string | undefined)[] {
  return screen.getAllByRole("button").map((one) => one.dataset.act);
}

function hear(change: Partial<Act>): void {
  const { page } = commander.operation;
  act(() =>
    page.recentActs.hearAct({ id: 1, page: page.number, ...change } as Act),
  );
}

beforeEach(async () => {
  commander = await makeCommander("OPERATOR");
  commander.answers["/api/v1/pose"] = { body: { state: "accepted" } };
  const { operation, authority } = commander;
  render(<PanelOf operation={operation} authority={authority} />);
});

afterEach(() => leave(commander));

test("SWR-CON-033 the button that commanded says what becomes of it", async () => {
  fireEvent.click(screen.getByRole("button", { name: "EGRESS" }));
  expect(marks()).toEqual([undefined, undefined, "sent"]);
  await waitFor(() => expect(marks()[2]).toBe("accepted"));
  expect(screen.getByRole("status").textContent).toContain(
    "Pose EGRESS: accepted",
  );
  hear({ state: "done" });
  expect(marks()).toEqual([undefined, undefined, "done"]);
  expect(screen.getByRole("status").textContent).toContain("done");
});

test("SWR-CON-033 what fails later says why", async () => {
  fireEvent.click(screen.getByRole("button", { name: "PARK" }));
  await waitFor(() => expect(marks()[1]).toBe("accepted"));
  hear({ state: "failed", message: "The needle is in.", axis: "insertion" });
  expect(screen.getByRole("alert").textContent).toBe(
    "The needle is in. (insertion)",
  );
  expect(marks()[1]).toBe("failed");
});

test("SWR-CON-033 another panel marks the button and has nothing to say of it", async () => {
  const { operation, authority } = commander;
  render(<PanelOf operation={operation} authority={authority} />);
  const [first] = screen.getAllByRole("button", { name: "Home yaw" });
  fireEvent.click(first as HTMLElement);
  await waitFor(() =>
    expect(marks().filter((mark) => mark === "done")).toHaveLength(2),
  );
  expect(screen.getAllByRole("status").map((one) => one.textContent)).toEqual([
    "Last command: Home yaw: done.",
    "",
  ]);
});
