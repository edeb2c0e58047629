// SPDX-License-Identifier: Apache-2.0
// The robot behind the server that the page came from.
import type { Path } from "@interface";
import { SharedStream } from "./shared_stream";
import type { Transport } from "./transport";

const STOP_PATH: Path = "/api/v1/stop";

/** The port for stops, if the page names one, is tried first: trouble of the console's port cannot hold it up. */
export function stopAddresses(
  page: Document,
  host: string,
  protocol = "http:",
): string[] {
  const name = protocol === "https:" ? "tls-stop-port" : "stop-port";
  const reported = page.querySelector<HTMLMetaElement>(
    `meta[name="boresight-${name}"]`,
  );
  const port = Number(reported?.content);
  return port > 0
    ? [`${protocol}//${host}:${port}${STOP_PATH}`, STOP_PATH]
    : [STOP_PATH];
}

export const transport: Transport = {
  request: (address, options) => fetch(address, options),
  openStream: (listener) => new SharedStream(listener),
  stopAddresses: () =>
    stopAddresses(document, location.hostname, location.protocol),
};
