// SPDX-License-Identifier: Apache-2.0
// The console with a robot in its own page: `make site`.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { defineConfig, mergeConfig } from "vite";
import { oneFile } from "./one_file.ts";
import console from "./vite.config.ts";

const at = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const robot = readFileSync(at("../../build/site/served.wasm"));

export default mergeConfig(
  console,
  defineConfig({
    base: "./",
    plugins: [
      oneFile("site.html", {
        robot: gzipSync(robot, { level: 9 }).toString("base64"),
      }),
    ],
    resolve: { alias: { "@transport": at("src/site/transport.ts") } },
    build: {
      outDir: "../../build/site/page",
      assetsInlineLimit: Infinity,
      cssCodeSplit: false,
      modulePreload: false,
      rolldownOptions: {
        input: at("site.html"),
        output: { codeSplitting: false },
      },
    },
  }),
);
