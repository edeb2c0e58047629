// SPDX-License-Identifier: Apache-2.0
// A bound against hanging, and no judgement: a busy machine takes its time to load a part that comes when it is needed.
import { configure } from "@testing-library/react";

configure({ asyncUtilTimeout: 20_000 });

// Files that share modules share a window too: each begins at the same address and with nothing stored.
history.replaceState(null, "", "/");
localStorage.clear();
sessionStorage.clear();
