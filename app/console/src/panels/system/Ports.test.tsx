// SPDX-License-Identifier: Apache-2.0
// Rule under test: each port of OpenIGTLink is shown with its state and its trouble.
import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { makePort } from "../../testing/robot";
import { Ports, stateText } from "./Ports";

afterEach(cleanup);

test("SWR-IGTL-028 a port that listens says how many came", () => {
  expect(stateText(makePort({ peers: 1 }))).toBe("1 peer");
  expect(stateText(makePort({ peers: 8, waiting: 2 }))).toBe(
    "8 peers, 2 without a place",
  );
});

test("SWR-IGTL-028 a port that calls says whether it is answered", () => {
  expect(stateText(makePort({ state: "calling" }))).toBe("calling");
  expect(stateText(makePort({ state: "connected" }))).toBe("connected");
  expect(stateText(makePort({ state: "waiting", again_ms: 3400 }))).toBe(
    "not connected, calling again in 4 s",
  );
});

test("SWR-IGTL-028 a row names address and the last trouble", () => {
  const port = makePort({
    troubles: 3,
    trouble: "called in vain: Connection refused",
  });
  render(<Ports ports={[port]} />);
  expect(screen.getByText("workphases 127.0.0.1:18936")).toBeTruthy();
  expect(
    screen.getByText("3 × trouble, last: called in vain: Connection refused"),
  ).toBeTruthy();
});

test("SWR-IGTL-028 without a trouble none is reported", () => {
  render(<Ports ports={[makePort()]} />);
  expect(screen.queryByText(/trouble/)).toBeNull();
});

test("SWR-IGTL-028 no ports are shown while OpenIGTLink does not run", () => {
  render(<Ports ports={[]} />);
  expect(screen.getByText("OpenIGTLink does not run.")).toBeTruthy();
});
