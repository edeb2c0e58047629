// SPDX-License-Identifier: Apache-2.0
import { useState } from "react";

type Theme = "dark" | "light";

const KEY = "boresight-theme";

/** A browser may refuse its storage. Then the choice lasts as long as the page. */
function recall(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function remember(theme: Theme): void {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // It was only a convenience.
  }
}

/** The theme chosen before; dark for a reading room otherwise. */
export function applyStoredTheme(): void {
  document.documentElement.dataset.theme =
    recall() === "light" ? "light" : "dark";
}

export function ThemeButton() {
  const [theme, setTheme] = useState<Theme>(
    document.documentElement.dataset.theme === "light" ? "light" : "dark",
  );
  const other: Theme = theme === "dark" ? "light" : "dark";
  const change = () => {
    document.documentElement.dataset.theme = other;
    remember(other);
    setTheme(other);
  };
  return (
    <button type="button" className="theme-button" onClick={change}>
      {other === "light" ? "Light theme" : "Dark theme"}
    </button>
  );
}
