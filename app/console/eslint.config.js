// SPDX-License-Identifier: Apache-2.0
import js from "@eslint/js";
import reactHooks from "eslint-plugin-react-hooks";
import { defineConfig } from "eslint/config";
import tseslint from "typescript-eslint";

const networkNames = [
  "fetch",
  "EventSource",
  "WebSocket",
  "XMLHttpRequest",
  "Worker",
  "SharedWorker",
  "BroadcastChannel",
  "sendBeacon",
  "locks",
];
const message = "The robot is reached by @transport alone.";

export default defineConfig(
  { ignores: ["node_modules", "*.config.js", "*.local.*"] },
  js.configs.recommended,
  tseslint.configs.recommendedTypeChecked,
  reactHooks.configs.flat.recommended,
  {
    linterOptions: { reportUnusedDisableDirectives: "error" },
    languageOptions: {
      parserOptions: {
        projectService: true,
        tsconfigRootDir: import.meta.dirname,
      },
    },
    rules: {
      // Interfaces write their methods short, and none is taken from its object.
      "@typescript-eslint/unbound-method": "off",
      // Values from outside, as data or an answer, are taken over in an effect.
      "react-hooks/set-state-in-effect": "off",
      "no-restricted-syntax": [
        "error",
        {
          selector: "JSXAttribute[name.name='dangerouslySetInnerHTML']",
          message: "Text of the network is no HTML.",
        },
      ],
    },
  },
  {
    files: ["src/**"],
    ignores: ["src/testing/**", "src/**/*.test.ts", "src/**/*.test.tsx"],
    rules: {
      // As tools/functions.rb has them for C.
      complexity: ["error", 15],
      "max-lines-per-function": ["error", 60],
    },
  },
  {
    files: ["src/**"],
    ignores: ["src/transport/**"],
    rules: {
      "no-restricted-globals": [
        "error",
        ...networkNames.map((name) => ({ name, message })),
      ],
      "no-restricted-properties": [
        "error",
        ...networkNames.flatMap((property) =>
          ["window", "globalThis", "self", "navigator"].map((object) => ({
            object,
            property,
            message,
          })),
        ),
      ],
    },
  },
);
