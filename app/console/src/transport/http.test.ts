// SPDX-License-Identifier: Apache-2.0
// Rule under test: a stop first goes to the port that the page names, by the protocol that the page came by.
import { expect, test } from "vitest";
import { stopAddresses } from "./http";

const OWN = "http://127.0.0.1:40000/api/v1/stop";
const CONSOLE = "/api/v1/stop";

test("SWR-CON-007 a page that was given no port asks the console's", () => {
  const page = document.implementation.createHTMLDocument();
  expect(stopAddresses(page, "127.0.0.1")).toEqual([CONSOLE]);
  page.head.innerHTML = '<meta name="boresight-stop-port" content="00000">';
  expect(stopAddresses(page, "127.0.0.1")).toEqual([CONSOLE]);
  page.head.innerHTML = '<meta name="boresight-stop-port" content="40000">';
  expect(stopAddresses(page, "127.0.0.1")).toEqual([OWN, CONSOLE]);
});

test("SWR-SESS-019 a page that came by TLS asks by TLS", () => {
  const page = document.implementation.createHTMLDocument();
  page.head.innerHTML =
    '<meta name="boresight-stop-port" content="40000"><meta name="boresight-tls-stop-port" content="08444">';
  expect(stopAddresses(page, "robot.example", "https:")).toEqual([
    "https://robot.example:8444/api/v1/stop",
    CONSOLE,
  ]);
});
