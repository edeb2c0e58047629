// SPDX-License-Identifier: Apache-2.0
// A page of one file: scripts and styles stand in it, and it may run and load nothing else. Modules and requests do not
// work from file://. Its script is packed, and run by a small one that expands it.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { fileURLToPath } from "node:url";
import { build, type Plugin, type Rolldown } from "vite";

/** Texts in the page beside its scripts and styles, by the id of their element. */
export type Enclosed = Readonly<Record<string, string>>;

const SCRIPT = /<script type="module"[^>]* src="\.\/([^"]+)"><\/script>/;
const ICON = /(?<=<link rel="icon"[^>]* href=")\.\/([^"]+\.svg)(?=")/;
const STYLE = /<link rel="stylesheet"[^>]* href="\.\/([^"]+)">/;

const UNPACK = fileURLToPath(new URL("src/site/unpack.ts", import.meta.url));
// Format that src/site/expand.ts reads.
const LZMA = ["--format=lzma", "--lzma1=preset=9e,lc=3,lp=0,pb=0"];

/** As src/site/packed.ts expands it. */
export function packed(content: string | Buffer): string {
  return execFileSync("xz", [...LZMA, "-c"], { input: content }).toString(
    "base64",
  );
}

/** The script that runs the packed one. */
async function unpacking(): Promise<string> {
  const built = await build({
    configFile: false,
    logLevel: "warn",
    build: {
      write: false,
      target: "es2022",
      modulePreload: false,
      rolldownOptions: { input: UNPACK },
    },
  });
  const [output] = [built].flat();
  if (output === undefined || !("output" in output)) {
    throw new Error("The script that unpacks was not built.");
  }
  return output.output[0].code.trim();
}

function hashOf(text: string): string {
  return `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
}

/** No text of a script ends its element, or begins a comment in it. */
function asScript(code: string): string {
  return code.replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
}

function policyOf(scripts: readonly string[], style: string): string {
  return [
    "default-src 'none'",
    `script-src ${scripts.map(hashOf).join(" ")} 'wasm-unsafe-eval'`,
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
      async handler(_, bundle) {
        const html = bundle[from];
        if (html?.type !== "asset") {
          throw new Error(`There is no page ${from}.`);
        }
        const page = String(html.source);
        const code = take(bundle, page, SCRIPT);
        const unpack = asScript(await unpacking());
        const style = take(bundle, page, STYLE);
        const icon = Buffer.from(take(bundle, page, ICON)).toString("base64");
        delete bundle[from];
        const rest = Object.keys(bundle);
        if (rest.length > 0) {
          throw new Error(`The page needs more files: ${rest.join(", ")}.`);
        }
        const policy = `<meta http-equiv="Content-Security-Policy" content="${policyOf([unpack, code], style)}" />`;
        const texts = Object.entries({
          ...enclosed,
          script: packed(code),
        }).map(
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
              `${texts.join("")}<script type="module">${unpack}</script></body>`,
          );
        this.emitFile({ type: "asset", fileName: to, source });
      },
    },
  };
}
