// SPDX-License-Identifier: Apache-2.0
// The log as the server searches it. An event of the stream only shows that there is more to ask for.
import { Log, type EventSeverity, type LogEntry } from "@interface";
import { ask } from "../state/answer";
import type { Address, Page } from "../state/page";

/** The page keeps no more; the rest is in the files. */
export const MOST_ENTRIES = 2000;
const LIMIT = 200;

export interface LogFilter {
  /** These events and those above. */
  level: EventSeverity;
  /** In sentence or name; empty: any. */
  text: string;
}

export interface LogReading {
  /** Newest first. */
  entries: readonly LogEntry[];
  /** Events that neither memory nor log has. */
  lost: number;
  /** The oldest that there are have been read. */
  isComplete: boolean;
  /** The server has not answered the last question. */
  hasFailed: boolean;
}

const nothing: LogReading = {
  entries: [],
  lost: 0,
  isComplete: false,
  hasFailed: false,
};

/** The filter as the server's query has it. */
export function queryOf({ level, text }: LogFilter): string {
  const query = new URLSearchParams({ level });
  if (text !== "") {
    query.set("text", text);
  }
  return query.toString();
}

/** @satisfies SWR-CON-038 */
export class LogReader {
  private readonly page: Page;
  private readonly listeners = new Set<() => void>();
  private reading = nothing;
  private filter: LogFilter = { level: "INFORMATION", text: "" };
  /** Number of the event that is to be asked for; null before the first answer. */
  private next: number | null = null;
  /** The newest that the stream has reported. */
  private newest = -1;
  private isAsking = false;

  constructor(page: Page) {
    this.page = page;
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  readonly getReading = (): LogReading => this.reading;

  /** Begins anew. */
  search(filter: LogFilter): void {
    this.filter = filter;
    this.next = null;
    void this.read();
  }

  /** There are events up to this one. Fewer than before: control has started again. */
  follow(newest: number): void {
    if (newest < this.newest) {
      this.next = null;
    }
    this.newest = newest;
    void this.read();
  }

  /** Reads those before the oldest one. */
  async readOlder(): Promise<void> {
    const oldest = this.reading.entries.at(-1);
    const { filter } = this;
    if (oldest === undefined) {
      return;
    }
    // It says milliseconds; others of the same one may be older.
    const until = oldest.utc.replace("Z", "999Z");
    const log = await this.ask(`to=${until}`);
    if (log !== null && filter === this.filter) {
      const older = log.entries
        .filter(({ number }) => number < oldest.number)
        .reverse();
      const entries = [...this.reading.entries, ...older];
      this.replace({ entries, isComplete: log.entries.length < LIMIT });
    }
  }

  /** One question at a time; what has come meanwhile is asked for with the next. */
  private async read(): Promise<void> {
    if (this.isAsking) {
      return;
    }
    this.isAsking = true;
    while (this.next === null || this.next <= this.newest) {
      if (!(await this.readOn())) {
        break;
      }
    }
    this.isAsking = false;
  }

  /** False when there is no answer. */
  private async readOn(): Promise<boolean> {
    const { filter, next } = this;
    const isAnew = next === null || next === 0;
    const log = await this.ask(isAnew ? "" : `after=${next - 1}`);
    if (filter !== this.filter || next !== this.next) {
      return true;
    }
    if (log === null) {
      return false;
    }
    if (next !== null && log.next <= next) {
      return false; // It knows of no more.
    }
    this.next = log.next;
    const entries = [...log.entries].reverse();
    this.replace(
      isAnew
        ? { entries, lost: log.lost, isComplete: entries.length < LIMIT }
        : this.joined(entries, log.lost),
    );
    return true;
  }

  private joined(newer: readonly LogEntry[], lost: number) {
    const all = [...newer, ...this.reading.entries];
    const entries = all.slice(0, MOST_ENTRIES);
    return {
      entries,
      lost: this.reading.lost + lost,
      isComplete: this.reading.isComplete && entries.length === all.length,
    };
  }

  private async ask(query: string): Promise<Log | null> {
    const address: Address = `/api/v1/log?limit=${LIMIT}&${queryOf(this.filter)}${query === "" ? "" : `&${query}`}`;
    const log = await ask(this.page, address, Log);
    this.replace({ hasFailed: log === null });
    return log;
  }

  private replace(change: Partial<LogReading>): void {
    this.reading = { ...this.reading, ...change };
    this.listeners.forEach((listener) => listener());
  }
}
