// SPDX-License-Identifier: Apache-2.0
// Runs the script of a page of one file, which stands in it as packed text. The page's policy names its hash.
import { expanded } from "./packed";

const script = document.createElement("script");
script.type = "module";
script.textContent = new TextDecoder().decode(
  expanded(document.getElementById("script")?.textContent ?? ""),
);
document.body.append(script);
