// SPDX-License-Identifier: Apache-2.0
import { globSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig, mergeConfig } from "vitest/config";
import { BaseSequencer, type TestSpecification } from "vitest/node";
import console from "./vite.config.ts";

const folder = fileURLToPath(new URL(".", import.meta.url));

// A file of tests that replaces modules has modules of its own. The others share theirs: to load them anew for each took
// most of the time.
const replacing = globSync("src/**/*.test.{ts,tsx}", { cwd: folder }).filter(
  (file) => readFileSync(folder + file, "utf8").includes("vi.mock("),
);

/** The same order each time, however long each took before. */
class ByName extends BaseSequencer {
  override sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    return Promise.resolve(
      files.toSorted((one, other) => (one.moduleId < other.moduleId ? -1 : 1)),
    );
  }
}

export default mergeConfig(
  console,
  defineConfig({
    test: {
      environment: "jsdom",
      setupFiles: ["src/testing/setup.ts"],
      testTimeout: 30_000,
      maxWorkers: 1,
      sequence: { sequencer: ByName },
      projects: [
        {
          extends: true,
          test: {
            name: "together",
            include: ["src/**/*.test.{ts,tsx}"],
            exclude: replacing,
            isolate: false,
          },
        },
        { extends: true, test: { name: "apart", include: replacing } },
      ],
    },
  }),
);
