// SPDX-License-Identifier: Apache-2.0
// Rule under test: a console that has another transport asks the network for nothing.
import {
  act,
  cleanup,
  fireEvent,
  render,
  screen,
  waitFor,
} from "@testing-library/react";
import { afterEach, expect, test, vi } from "vitest";
import type { Path } from "@interface";
import { App } from "../App";
import { TelemetryStore } from "../state/store";
import { makeRobot } from "../testing/robot";
import type { StreamListener, Transport } from "./transport";

const STOP = "stop of the other transport";
const asked: string[] = [];
let listener: StreamListener | null = null;

vi.mock("@transport", () => ({
  transport: {
    request: (address) => {
      asked.push(address);
      return Promise.resolve(new Response("{}"));
    },
    openStream: (joined) => {
      listener = joined;
      return { close: () => undefined };
    },
    stopAddresses: () => [STOP],
  } satisfies Transport,
}));

const network = vi.fn();

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

test("SWR-SITE-005 a console on another transport asks the network for nothing", async () => {
  for (const name of ["fetch", "EventSource", "SharedWorker"]) {
    vi.stubGlobal(name, network);
  }
  const store = new TelemetryStore();
  store.start();
  render(<App store={store} />);
  act(() => listener?.hear("state", JSON.stringify(makeRobot())));
  fireEvent.click(screen.getByRole("button", { name: /STOP MOTION/ }));
  const paths: Path[] = ["/api/v1/session", "/api/v1/robot", "/api/v1/modes"];
  await waitFor(() =>
    expect(asked).toEqual(expect.arrayContaining([STOP, ...paths])),
  );
  expect(network).not.toHaveBeenCalled();
  store.stop();
});
