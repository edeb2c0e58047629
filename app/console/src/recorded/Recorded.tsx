// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState } from "react";
import { Boundary } from "../parts/Boundary";
import { AnyFileDrop } from "../parts/FileDrop";
import { ThemeChoice } from "../parts/ThemeChoice";
import { Recording, type RecordingDocument } from "../replay/recording";
import { Replay } from "../replay/Replay";
import type { ReaderPort, Report } from "./messages";
import "./Recorded.css";

/** State of the file that was opened last. */
type Opened =
  | { kind: "reading"; name: string; share: number }
  | { kind: "refused"; name: string; reason: string }
  | { kind: "shown"; name: string; recording: Recording };

const NOTHING =
  "There is nothing to show: no cycle of it is known, as none follows a checkpoint.";

function openedOf(name: string, document: Uint8Array): Opened {
  const text = new TextDecoder().decode(document);
  const recording = new Recording(JSON.parse(text) as RecordingDocument);
  return recording.isEmpty
    ? { kind: "refused", name, reason: NOTHING }
    : { kind: "shown", name, recording };
}

/** After each report of the file's reader. */
function openedAfter(name: string, report: Report): Opened {
  switch (report.kind) {
    case "share":
      return { kind: "reading", name, share: report.share };
    case "read":
      try {
        return openedOf(name, report.document);
      } catch (cause) {
        return { kind: "refused", name, reason: (cause as Error).message };
      }
    case "refused":
      return { kind: "refused", name, reason: report.reason };
  }
}

/**
 * Reads one file at a time: who opens another one gives up the one before.
 *
 * @satisfies SWR-SITE-037
 */
function useReader(
  newReader: () => ReaderPort,
  packed: string,
): [Opened | null, (file: File) => void] {
  const [opened, setOpened] = useState<Opened | null>(null);
  const reader = useRef<ReaderPort | null>(null);
  useEffect(() => () => reader.current?.terminate(), []);
  const open = (file: File) => {
    const { name } = file;
    const port = newReader();
    const take = (report: Report) => setOpened(openedAfter(name, report));
    reader.current?.terminate();
    reader.current = port;
    port.onerror = ({ message }) => take({ kind: "refused", reason: message });
    port.onmessage = ({ data }) => take(data);
    take({ kind: "share", share: 0 });
    port.postMessage({ packed, file });
  };
  return [opened, open];
}

function State({ opened }: { opened: Opened }) {
  switch (opened.kind) {
    case "reading":
      return (
        <p className="recorded-state">
          <progress
            max={1}
            value={opened.share}
            aria-label={`Reading ${opened.name}`}
          />
          <span>
            Reading <bdi>{opened.name}</bdi>, {Math.floor(100 * opened.share)} %
          </span>
        </p>
      );
    case "refused":
      return (
        <p className="recorded-state" role="alert">
          <strong>
            <bdi>{opened.name}</bdi> is not shown.
          </strong>{" "}
          <span className="recorded-reason">{opened.reason}</span>
        </p>
      );
    case "shown":
      return (
        <p className="recorded-state" role="status">
          <span>
            Shown is <bdi>{opened.name}</bdi>.
          </span>
        </p>
      );
  }
}

function Welcome() {
  return (
    <>
      <main>
        <h1>A recording of Boresight</h1>
        <p>
          Open a file of the black box, such as
          blackbox-000001-20261123T152442Z.bsr. The replay in this page verifies
          every byte of it, computes it again and shows any cycle. The file
          stays in this page: nothing is sent anywhere.
        </p>
        <p>
          <a href="./index.html">The robot in a page</a>
        </p>
      </main>
      <footer>
        <span>Boresight recording</span>
        <ThemeChoice />
      </footer>
    </>
  );
}

/** A page on which recordings are opened. */
export function Recorded({
  newReader,
  packed,
}: {
  newReader: () => ReaderPort;
  /** The module that reads them. */
  packed: string;
}) {
  const [opened, open] = useReader(newReader, packed);
  return (
    <>
      <section className="recorded" aria-label="File">
        <AnyFileDrop label="Open a recording" accept=".bsr" take={open} />
        {opened !== null && <State opened={opened} />}
      </section>
      {opened?.kind === "shown" ? (
        <Boundary name="recording">
          <Replay recording={opened.recording} />
        </Boundary>
      ) : (
        <Welcome />
      )}
    </>
  );
}
