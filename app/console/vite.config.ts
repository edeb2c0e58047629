// SPDX-License-Identifier: Apache-2.0
import react from "@vitejs/plugin-react";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const generated = (path: string) =>
  fileURLToPath(new URL(`../../build/gen/${path}`, import.meta.url));

export default defineConfig({
  base: "/",
  plugins: [react()],
  resolve: {
    alias: {
      "@interface": generated("interface/app/api.ts"),
      "@charts": generated("charts/charts.ts"),
      "@drawings": generated("robot/drawings.ts"),
      "@transport": fileURLToPath(
        new URL("src/transport/http.ts", import.meta.url),
      ),
    },
  },
  build: {
    outDir: "../../build/console",
    emptyOutDir: true,
    target: "es2022",
    // Inlined files would need a weaker content security policy.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  // For development against a running boresight-http.
  server: {
    proxy: { "/api": { target: "http://127.0.0.1:8080", changeOrigin: true } },
  },
});
