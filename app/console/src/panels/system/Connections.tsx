// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";
import { Communication, type Connection, type Path } from "@interface";
import { change } from "../../state/answer";
import { formatBytes, formatDuration } from "../../words/format";
import type { Method, Page } from "../../state/page";
import { Shape } from "../../parts/drawn/Shape";
import { AskTwice } from "../../parts/AskTwice";
import { WideTable } from "../../parts/WideTable";
import "./Connections.css";

const columns = [
  "From",
  "Port",
  "Commands",
  { number: "In" },
  { number: "Out" },
  { number: "Refused" },
  "Last message",
  "Status sent",
  { number: "Silent for" },
  { number: "Here for" },
  "Keep alive",
  "End",
];

/** An act on one connection. */
type Act = (method: Method, what: string, body?: object) => void;

function Traffic({ messages, bytes }: { messages: number; bytes: number }) {
  return (
    <td className="number">
      {messages} ({formatBytes(bytes)})
    </td>
  );
}

function Row({
  connection,
  isBarred,
  act,
}: {
  connection: Connection;
  isBarred: boolean;
  act: Act;
}) {
  const { address, keep_alive } = connection;
  return (
    <tr>
      <th scope="row">{address}</th>
      <td>
        {connection.port}, {connection.dialect}
        {connection.is_waiting && ", waits for a place"}
      </td>
      <td>
        <Shape level={connection.has_authority ? "active" : "unknown"} />
        {connection.has_authority ? "commands" : "no"}
      </td>
      <Traffic messages={connection.messages_in} bytes={connection.bytes_in} />
      <Traffic
        messages={connection.messages_out}
        bytes={connection.bytes_out}
      />
      <td className="number">{connection.errors}</td>
      <td>{connection.last_message ?? "none yet"}</td>
      <td>{connection.status ?? "none yet"}</td>
      <td className="number">{formatDuration(connection.silent_s * 1000)}</td>
      <td className="number">{formatDuration(connection.age_s * 1000)}</td>
      <td>
        <input
          type="checkbox"
          aria-label={`Ask whether ${address} is still there`}
          checked={keep_alive}
          disabled={isBarred}
          onChange={() => act("PUT", "keep-alive", { on: !keep_alive })}
        />
      </td>
      <td>
        <AskTwice
          label={`Disconnect ${address}?`}
          question={`Disconnect ${address}?`}
          isBarred={isBarred}
          onSure={() => act("POST", "disconnect")}
        >
          Disconnect
        </AskTwice>
      </td>
    </tr>
  );
}

/**
 * A row for each connection of OpenIGTLink. Whether one may be ended is the server's to say.
 *
 * @satisfies SWR-CON-037
 * @satisfies SWR-CON-112
 */
export function Connections({
  connections,
  page,
  obstacle,
  takeAnswer,
}: {
  connections: readonly Connection[];
  page: Page;
  /** Why nothing can be changed from here, or null. */
  obstacle: string | null;
  /** Takes the server's answer to a change. */
  takeAnswer: (communication: Communication) => void;
}) {
  const [problem, setProblem] = useState<string | null>(null);
  const act = async (
    number: number,
    ...[method, what, body]: Parameters<Act>
  ) => {
    const path = `/api/v1/communication/${number}/${what}` as Path;
    const changed = await change(page, method, path, Communication, body);
    setProblem("problem" in changed ? changed.problem : null);
    if ("answer" in changed) {
      takeAnswer(changed.answer);
    }
  };
  if (connections.length === 0) {
    return <p>Nobody is connected.</p>;
  }
  return (
    <div className="connections">
      {obstacle !== null && <p className="order-obstacle">{obstacle}</p>}
      {problem !== null && (
        <p className="order-problem" role="alert">
          {problem}
        </p>
      )}
      <WideTable label="Connections" columns={columns}>
        {connections.map((connection) => (
          <Row
            key={connection.number}
            connection={connection}
            isBarred={obstacle !== null}
            act={(...what) => void act(connection.number, ...what)}
          />
        ))}
      </WideTable>
    </div>
  );
}
