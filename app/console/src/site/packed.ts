// SPDX-License-Identifier: Apache-2.0
// A module that stands in its page as text: gzip, as base64.

export async function moduleOf(packed: string): Promise<WebAssembly.Module> {
  const bytes = Uint8Array.from(atob(packed), (one) => one.charCodeAt(0));
  const stream = new Blob([bytes])
    .stream()
    .pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}
