// SPDX-License-Identifier: Apache-2.0
// The one way from the console to its robot. The name "@transport" stands for the one that a build of the console has.

/** Entries of the log that are kept. */
export const LOG_LENGTH = 50;

export const streamEvents = ["hello", "state", "log", "act"] as const;
export type StreamEvent = (typeof streamEvents)[number];

/** The messages to a tab. */
export interface StreamListener {
  hear(type: StreamEvent, data: string): void;
  /** The stream has ended, for this reason if the server gave one. */
  lose(reason: string | null): void;
}

export interface Stream {
  close(): void;
}

/** @satisfies SWR-SITE-005 */
export interface Transport {
  /** Answers as fetch() does; rejects without an answer, and once the signal of `options` aborts. */
  request(address: string, options: RequestInit): Promise<Response>;
  openStream(listener: StreamListener): Stream;
  /** Where a stop can be requested, the best way first. */
  stopAddresses(): string[];
}
