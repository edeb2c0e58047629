// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";

type Theme = "dark" | "light";

const KEY = "boresight-theme";

/** The theme chosen before; dark for a reading room otherwise. */
export function applyStoredTheme(): void {
  const stored = localStorage.getItem(KEY);
  document.documentElement.dataset.theme =
    stored === "light" ? "light" : "dark";
}

export function ThemeButton() {
  const [theme, setTheme] = useState<Theme>(
    document.documentElement.dataset.theme === "light" ? "light" : "dark",
  );
  const other: Theme = theme === "dark" ? "light" : "dark";
  const change = () => {
    document.documentElement.dataset.theme = other;
    localStorage.setItem(KEY, other);
    setTheme(other);
  };
  return (
    <button type="button" className="theme-button" onClick={change}>
      {other === "light" ? "Light theme" : "Dark theme"}
    </button>
  );
}
