// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";
import { keep, recall } from "../state/keep";

const themes = ["system", "light", "dark"] as const;
type Theme = (typeof themes)[number];

const KEY = "theme";

function themeOf(text: string | null): Theme {
  return themes.find((theme) => theme === text) ?? "system";
}

/**
 * The theme chosen before; the system's otherwise.
 *
 * @satisfies SWR-CON-022
 */
export function applyKeptTheme(): void {
  document.documentElement.dataset.theme = themeOf(recall(KEY));
}

export function ThemeChoice() {
  const [theme, setTheme] = useState(() =>
    themeOf(document.documentElement.dataset.theme ?? null),
  );
  const choose = (text: string) => {
    const chosen = themeOf(text);
    keep(KEY, chosen);
    document.documentElement.dataset.theme = chosen;
    setTheme(chosen);
  };
  return (
    <label className="theme-choice">
      Theme{" "}
      <select value={theme} onChange={(event) => choose(event.target.value)}>
        {themes.map((one) => (
          <option key={one}>{one}</option>
        ))}
      </select>
    </label>
  );
}
