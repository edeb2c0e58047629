// SPDX-License-Identifier: Apache-2.0
// A bound against hanging, and no judgement: a busy machine takes its time to load a part that comes when it is needed.
import { configure } from "@testing-library/react";
import * as react from "react";

configure({ asyncUtilTimeout: 20_000 });

// Files that share modules share a window too: each begins at the same address and with nothing stored.
history.replaceState(null, "", "/");
localStorage.clear();
sessionStorage.clear();

// React in development keeps for each element the stack that made it, for its warnings; ten thousand in a second of the page's
// time, and then none until the next second. Where a test leads that time, this took a fifth of its own. The warnings stay.
const internals = Object.entries(react).find(([name]) =>
  name.startsWith("__CLIENT_INTERNALS"),
)?.[1] as object;
Object.defineProperty(internals, "recentlyCreatedOwnerStacks", {
  configurable: true,
  get: () => Infinity,
  set: () => undefined,
});
