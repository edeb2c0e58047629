// SPDX-License-Identifier: Apache-2.0
// The page on which recordings are opened, which has the replay in it.
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { applyKeptTheme } from "../parts/ThemeChoice";
import "../style.css";
import { Recorded } from "./Recorded";
import RecordedWorker from "./recorded_worker?worker&inline";

const packed = document.getElementById("replay")?.textContent ?? "";

applyKeptTheme();
createRoot(document.getElementById("root")!).render(
  <StrictMode>
    <Recorded newReader={() => new RecordedWorker()} packed={packed} />
  </StrictMode>,
);
