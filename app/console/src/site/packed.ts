// SPDX-License-Identifier: Apache-2.0
// Data that stands in its page as text: packed, as base64.
import { expand } from "./expand";

export function expanded(packed: string): Uint8Array<ArrayBuffer> {
  return expand(
    Uint8Array.from(atob(packed), (character) => character.charCodeAt(0)),
  );
}

export function moduleOf(packed: string): Promise<WebAssembly.Module> {
  return WebAssembly.compile(expanded(packed));
}
