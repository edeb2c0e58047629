// SPDX-License-Identifier: Apache-2.0
// The console of the product on a robot in its own page, and above it what that page is.
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { drawings } from "@drawings";
import "../main";
import { addressIn, askedIn, choiceIn, isOther } from "./address";
import { saveByTransport } from "./save";
import { Simulation } from "./Simulation";
import { transport } from "./transport";

const choice = choiceIn(location.hash);
window.addEventListener("hashchange", () => {
  if (isOther(location.hash, choice)) {
    location.reload();
  }
});

document.addEventListener("click", saveByTransport(transport));

const element = document.getElementById("simulation");
if (element === null) {
  throw new Error("The page has no element #simulation.");
}
createRoot(element).render(
  <StrictMode>
    <Simulation
      robot={transport}
      names={Object.keys(drawings)}
      asked={askedIn(location.hash)[1]}
      onAnew={() => {
        location.replace(addressIn(choice));
        location.reload();
      }}
    />
  </StrictMode>,
);
