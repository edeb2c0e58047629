// SPDX-License-Identifier: Apache-2.0
// A module that stands in its page as text: packed, as base64.
import { expand } from "./expand";

export function moduleOf(packed: string): Promise<WebAssembly.Module> {
  const bytes = Uint8Array.from(atob(packed), (one) => one.charCodeAt(0));
  return WebAssembly.compile(expand(bytes));
}
