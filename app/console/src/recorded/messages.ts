// SPDX-License-Identifier: Apache-2.0
// Messages between the page and the worker that reads a recording.

/** From the page, once. */
export interface Order {
  /** The module: gzip, as base64. */
  packed: string;
  file: File;
}

/** To the page. The last one is no share. */
export type Report =
  | { kind: "share"; share: number }
  /** JSON in UTF-8. */
  | { kind: "read"; document: Uint8Array<ArrayBuffer> }
  | { kind: "refused"; reason: string };

/** The part of a Worker that is used. */
export interface ReaderPort {
  onmessage: ((event: MessageEvent<Report>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  postMessage(order: Order): void;
  terminate(): void;
}
