// SPDX-License-Identifier: Apache-2.0
import { Logs, Recordings, type Path } from "@interface";
import { useAnswer } from "../../state/answer";
import { formatBytes, formatUtc } from "../../words/format";
import type { Page } from "../../state/page";
import { WideTable } from "../../parts/WideTable";

const ASK_AGAIN_MS = 10_000;

function timeText(utc: string | null): string {
  return utc === null ? "not known" : formatUtc(utc);
}

/** A row's name and size, and by what it is saved. */
function File({
  path,
  name,
  bytes,
  isPresent,
  times,
}: {
  path: Path;
  name: string;
  bytes: number;
  isPresent: boolean;
  times: readonly string[];
}) {
  return (
    <tr>
      <th scope="row">{name}</th>
      {times.map((time, index) => (
        <td key={index}>{time}</td>
      ))}
      <td className="number">{formatBytes(bytes)}</td>
      <td>{isPresent ? "being written" : "closed"}</td>
      <td>
        <a href={path} download={name} aria-label={`Save ${name}`}>
          Save
        </a>
      </td>
    </tr>
  );
}

/** @satisfies SWR-CON-038 */
export function LogFiles({ page }: { page: Page }) {
  const [reported] = useAnswer(page, "/api/v1/logs", Logs, ASK_AGAIN_MS);
  if (reported === null) {
    return <p>Not known yet.</p>;
  }
  const columns = ["Log", "From, UTC", "To, UTC", { number: "Size" }, "State"];
  return (
    <div className="archive">
      <WideTable
        label="Log files of this and earlier runs"
        columns={[...columns, "File"]}
      >
        {reported.logs.map(({ name, bytes, first, last, is_present }) => (
          <File
            key={name}
            path={`/api/v1/logs/${name}`}
            name={name}
            bytes={bytes}
            isPresent={is_present}
            times={[timeText(first), timeText(last)]}
          />
        ))}
      </WideTable>
    </div>
  );
}

/** @satisfies SWR-CON-038 */
export function RecordingFiles({ page }: { page: Page }) {
  const [reported] = useAnswer(
    page,
    "/api/v1/recordings",
    Recordings,
    ASK_AGAIN_MS,
  );
  if (reported === null) {
    return <p>Not known yet.</p>;
  }
  const columns = ["Recording", "Began, UTC", "Robot", { number: "Size" }];
  return (
    <div className="archive">
      <WideTable
        label="Recordings of this and earlier runs"
        columns={[...columns, "State", "File"]}
      >
        {reported.recordings.map(
          ({ name, bytes, started, robot, is_present }) => (
            <File
              key={name}
              path={`/api/v1/recordings/${name}`}
              name={name}
              bytes={bytes}
              isPresent={is_present}
              times={[timeText(started), robot ?? "not known"]}
            />
          ),
        )}
      </WideTable>
    </div>
  );
}
