// SPDX-License-Identifier: Apache-2.0
import {
  useEffect,
  useState,
  useSyncExternalStore,
  type ReactNode,
} from "react";
import type { EventSeverity, LogEntry, Path } from "@interface";
import { LogReader, queryOf, type LogFilter } from "../../words/log_reader";
import type { Page } from "../../state/page";
import { Log } from "./Log";
import "./LogSearch.css";

const CSV_PATH: Path = "/api/v1/log.csv";
const SEARCH_AFTER_MS = 300;
export const AGAIN_AFTER_MS = 2000;

export const severities: readonly EventSeverity[] = [
  "INFORMATION",
  "WARNING",
  "CRITICAL",
];

export function SeverityOptions() {
  return severities.map((severity) => (
    <option key={severity} value={severity}>
      {severity.toLowerCase()}
    </option>
  ));
}

/** The reader, searching and following. */
function useLog(page: Page, filter: LogFilter, newest: number | undefined) {
  const [reader] = useState(() => new LogReader(page));
  useEffect(() => {
    const wait = filter.text === "" ? 0 : SEARCH_AFTER_MS;
    const timer = setTimeout(() => reader.search(filter), wait);
    return () => clearTimeout(timer);
  }, [reader, filter]);
  useEffect(() => {
    if (newest !== undefined) {
      reader.follow(newest);
    }
  }, [reader, newest]);
  const reading = useSyncExternalStore(reader.subscribe, reader.getReading);
  const { hasFailed } = reading;
  useEffect(() => {
    const timer = setInterval(
      () => hasFailed && reader.search(filter),
      AGAIN_AFTER_MS,
    );
    return () => clearInterval(timer);
  }, [reader, filter, hasFailed]);
  return { reader, reading };
}

function Filter({
  filter,
  setFilter,
  children,
}: {
  filter: LogFilter;
  setFilter: (filter: LogFilter) => void;
  children: ReactNode;
}) {
  return (
    <div className="orders" role="search" aria-label="Events">
      <label>
        From level{" "}
        <select
          value={filter.level}
          onChange={(event) =>
            setFilter({
              ...filter,
              level: event.target.value as EventSeverity,
            })
          }
        >
          <SeverityOptions />
        </select>
      </label>
      <label>
        With the text{" "}
        <input
          type="search"
          value={filter.text}
          onChange={(event) =>
            setFilter({ ...filter, text: event.target.value })
          }
        />
      </label>
      {children}
    </div>
  );
}

/** Stops the list, and says what has come since. */
function Pause({
  pausedAt,
  since,
  onChange,
}: {
  pausedAt: number | null;
  since: number;
  onChange: () => void;
}) {
  return (
    <>
      <button type="button" onClick={onChange}>
        {pausedAt === null ? "Pause" : "Follow"}
      </button>
      <span className="log-since-pause" role="status">
        {pausedAt !== null && `Paused; ${since} new since.`}
      </span>
    </>
  );
}

/**
 * Events that fit, as the server finds them.
 *
 * @satisfies SWR-CON-038
 */
export function LogSearch({
  page,
  newest,
}: {
  page: Page;
  /** The newest entry of the stream. */
  newest: LogEntry | undefined;
}) {
  const [filter, setFilter] = useState<LogFilter>({
    level: "INFORMATION",
    text: "",
  });
  const [pausedAt, setPausedAt] = useState<number | null>(null);
  const { reader, reading } = useLog(page, filter, newest?.number);
  const { entries, isComplete, lost, hasFailed } = reading;
  const shown =
    pausedAt === null
      ? entries
      : entries.filter(({ number }) => number <= pausedAt);
  return (
    <div className="log-search">
      <Filter filter={filter} setFilter={setFilter}>
        <Pause
          pausedAt={pausedAt}
          since={entries.length - shown.length}
          onChange={() =>
            setPausedAt(pausedAt === null ? (entries[0]?.number ?? -1) : null)
          }
        />
        <a href={`${CSV_PATH}?${queryOf(filter)}`} download="events.csv">
          Save these as a table (CSV)
        </a>
      </Filter>
      {hasFailed && (
        <p className="order-problem">The log cannot be read now.</p>
      )}
      <Log log={shown} label="Events that fit" />
      <p className="log-rest">
        {shown.length} events.{lost > 0 && ` ${lost} are lost.`}{" "}
        {isComplete ? (
          "There are no older ones in this run."
        ) : (
          <button type="button" onClick={() => void reader.readOlder()}>
            Older ones
          </button>
        )}
      </p>
    </div>
  );
}
