// SPDX-License-Identifier: Apache-2.0
// The page for recordings: one file that needs no other, into which boresight-replay writes a recording.
import { createHash } from "node:crypto";
import { mergeConfig, type Plugin } from "vite";
import base from "./vite.config.ts";

function hashOf(text: string): string {
  return `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
}

/** Puts script and style into the page, which then allows these two and nothing from anywhere. */
function inOne(): Plugin {
  return {
    name: "in-one",
    enforce: "post",
    generateBundle(_, bundle) {
      let [script, style] = ["", ""];
      for (const [name, file] of Object.entries(bundle)) {
        if (file.type === "chunk") {
          // A text that ends a script, or begins a comment in it, has another letter.
          script += file.code.replace(/<(?=\/script|!--)/gi, "\\x3c");
          delete bundle[name];
        } else if (name.endsWith(".css")) {
          style += String(file.source);
          delete bundle[name];
        }
      }
      for (const page of Object.values(bundle)) {
        if (page.type === "asset" && page.fileName.endsWith(".html")) {
          const policy = `default-src 'none'; img-src data:; base-uri 'none'; form-action 'none'; script-src ${hashOf(script)}; style-src ${hashOf(style)}`;
          page.source = String(page.source)
            .replace(/<script[^>]* src=[^>]*><\/script>/, "")
            .replace(/<link[^>]* rel="?stylesheet[^>]*>/, "")
            .replace(
              /<meta charset[^>]*>/,
              (charset) =>
                `${charset}<meta http-equiv="Content-Security-Policy" content="${policy}">`,
            )
            .replace("</head>", () => `<style>${style}</style></head>`)
            .replace(
              "</body>",
              () => `<script type="module">${script}</script></body>`,
            );
        }
      }
    },
  };
}

export default mergeConfig(base, {
  plugins: [inOne()],
  build: {
    outDir: "../../build/replay",
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    cssCodeSplit: false,
    modulePreload: false,
    rollupOptions: { input: "replay.html" },
  },
});
