// SPDX-License-Identifier: Apache-2.0
// A page of one file: scripts and styles stand in it, and it may run and load nothing else. Modules and requests do not
// work from file://.
import { createHash } from "node:crypto";
import type { Plugin, Rolldown } from "vite";

/** Texts in the page beside its scripts and styles, by the id of their element. */
export type Enclosed = Readonly<Record<string, string>>;

const SCRIPT = /<script type="module"[^>]* src="\.\/([^"]+)"><\/script>/;
const ICON = /(?<=<link rel="icon"[^>]* href=")\.\/([^"]+\.svg)(?=")/;
const STYLE = /<link rel="stylesheet"[^>]* href="\.\/([^"]+)">/;

function hashOf(text: string): string {
  return `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
}

/** No text of a script ends its element, or begins a comment in it. */
function asScript(code: string): string {
  return code.replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
}

function policyOf(code: string, style: string): string {
  return [
    "default-src 'none'",
    `script-src ${hashOf(code)} 'wasm-unsafe-eval'`,
    `style-src ${hashOf(style)}`,
    "img-src data:",
    "worker-src blob:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
}

/** Takes what the page names by `place` out of the bundle. */
function take(
  bundle: Rolldown.OutputBundle,
  page: string,
  place: RegExp,
): string {
  const [, name = ""] = place.exec(page) ?? [];
  const file = bundle[name];
  if (file === undefined) {
    throw new Error(`The page names no file as ${place.source}.`);
  }
  delete bundle[name];
  return file.type === "chunk" ? file.code : String(file.source);
}

/**
 * Puts the page `from` into `to`, which may be opened without a server.
 *
 * @satisfies SWR-SITE-015
 * @satisfies SWR-SITE-038
 */
export function oneFile(from: string, to: string, enclosed: Enclosed): Plugin {
  return {
    name: "one-file",
    generateBundle: {
      order: "post",
      handler(_, bundle) {
        const html = bundle[from];
        if (html?.type !== "asset") {
          throw new Error(`There is no page ${from}.`);
        }
        const page = String(html.source);
        const code = asScript(take(bundle, page, SCRIPT));
        const style = take(bundle, page, STYLE);
        const icon = Buffer.from(take(bundle, page, ICON)).toString("base64");
        delete bundle[from];
        const rest = Object.keys(bundle);
        if (rest.length > 0) {
          throw new Error(`The page needs more files: ${rest.join(", ")}.`);
        }
        const policy = `<meta http-equiv="Content-Security-Policy" content="${policyOf(code, style)}" />`;
        const texts = Object.entries(enclosed).map(
          ([id, text]) =>
            `<script type="text/plain" id="${id}">${text}</script>`,
        );
        const source = page
          .replace(SCRIPT, "")
          .replace(ICON, `data:image/svg+xml;base64,${icon}`)
          .replace(STYLE, () => `<style>${style}</style>`)
          .replace("<title>", () => `${policy}\n    <title>`)
          .replace(
            "</body>",
            () =>
              `${texts.join("")}<script type="module">${code}</script></body>`,
          );
        this.emitFile({ type: "asset", fileName: to, source });
      },
    },
  };
}
