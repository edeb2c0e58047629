// SPDX-License-Identifier: Apache-2.0
// Output of `make site`: the console with a robot in its own page, and with --mode recorded the page on which recordings
// are opened. Each is one file with its module in it.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig, mergeConfig } from "vite";
import { oneFile, packed } from "./one_file.ts";
import console from "./vite.config.ts";

const at = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const packedModule = (module: string) =>
  packed(readFileSync(at(`../../build/site/${module}`)));

const robot = {
  page: "site.html",
  plugin: () =>
    oneFile("site.html", "index.html", { robot: packedModule("served.wasm") }),
};
const recorded = {
  page: "recorded.html",
  plugin: () =>
    oneFile("recorded.html", "replay.html", {
      replay: packedModule("recorded.wasm"),
    }),
};

export default defineConfig(({ mode }) => {
  const { page, plugin } = mode === "recorded" ? recorded : robot;
  return mergeConfig(
    console,
    defineConfig({
      base: "./",
      plugins: [plugin()],
      resolve: { alias: { "@transport": at("src/site/transport.ts") } },
      build: {
        outDir: "../../build/site/page",
        emptyOutDir: false,
        assetsInlineLimit: Infinity,
        cssCodeSplit: false,
        modulePreload: false,
        rolldownOptions: {
          input: at(page),
          output: { codeSplitting: false },
        },
      },
    }),
  );
});
