// SPDX-License-Identifier: Apache-2.0
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { App, Emergency } from "./App";
import { Boundary } from "./parts/Boundary";
import { applyKeptTheme } from "./parts/ThemeChoice";
import { TelemetryStore } from "./state/store";
import "./style.css";

applyKeptTheme();
const store = new TelemetryStore();
store.start();

const root = document.getElementById("root");
if (root === null) {
  throw new Error("The page has no element #root.");
}
createRoot(root).render(
  <StrictMode>
    <Boundary name="console" instead={<Emergency />}>
      <App store={store} />
    </Boundary>
  </StrictMode>,
);
