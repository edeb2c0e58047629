// SPDX-License-Identifier: Apache-2.0
import type { Port } from "@interface";

function peersText({ peers, waiting }: Port): string {
  const seated = peers === 1 ? "1 peer" : `${peers} peers`;
  return waiting === 0 ? seated : `${seated}, ${waiting} without a place`;
}

/** A port that calls has one peer, or none. */
export function stateText(port: Port): string {
  switch (port.state) {
    case "listening":
      return peersText(port);
    case "calling":
      return "calling";
    case "waiting":
      return `not connected, calling again in ${Math.ceil(port.again_ms / 1000)} s`;
    case "connected":
      return "connected";
  }
}

function isReached({ state }: Port): boolean {
  return state === "listening" || state === "connected";
}

function Row({ port }: { port: Port }) {
  return (
    <>
      <dt>
        {port.name} {port.address}
      </dt>
      <dd>
        {port.dialect},{" "}
        <span className={isReached(port) ? "" : "port-unreached"}>
          {stateText(port)}
        </span>
        {port.trouble !== null && (
          <span className="port-trouble">
            {port.troubles} × trouble, last: {port.trouble}
          </span>
        )}
      </dd>
    </>
  );
}

/**
 * One row for each port of OpenIGTLink.
 *
 * @satisfies SWR-IGTL-028
 */
export function Ports({ ports }: { ports: readonly Port[] }) {
  if (ports.length === 0) {
    return <p>OpenIGTLink does not run.</p>;
  }
  return (
    <dl className="facts ports">
      {ports.map((port) => (
        <Row key={port.name} port={port} />
      ))}
    </dl>
  );
}
