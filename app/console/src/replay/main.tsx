// SPDX-License-Identifier: Apache-2.0
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { Boundary } from "../parts/Boundary";
import { applyKeptTheme } from "../parts/ThemeChoice";
import "../style.css";
import { recordingOf } from "./recording";
import { Replay } from "./Replay";

function Unreadable() {
  return (
    <main>
      <p className="panel-failed">
        There is no recording in this page that it can read.
      </p>
    </main>
  );
}

function Page() {
  const recording = recordingOf(document);
  return recording === null || recording.isEmpty ? (
    <Unreadable />
  ) : (
    <Replay recording={recording} />
  );
}

applyKeptTheme();
createRoot(document.getElementById("root")!).render(
  <StrictMode>
    <Boundary name="recording" instead={<Unreadable />}>
      <Page />
    </Boundary>
  </StrictMode>,
);
