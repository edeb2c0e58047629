// SPDX-License-Identifier: Apache-2.0
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { App } from "./App";
import { applyStoredTheme } from "./parts/ThemeButton";
import { TelemetryStore } from "./store";
import "./style.css";

applyStoredTheme();
const store = new TelemetryStore();
store.start();

const root = document.getElementById("root");
if (root === null) {
  throw new Error("The page has no element #root.");
}
createRoot(root).render(
  <StrictMode>
    <App store={store} />
  </StrictMode>,
);
