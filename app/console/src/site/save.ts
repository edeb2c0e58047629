// SPDX-License-Identifier: Apache-2.0
// A file that the console links to at its server comes from the robot of the page. Followed, the link would lead away.
import { saveText } from "../words/download";
import type { Transport } from "../transport/transport";

export function saveByTransport({ request }: Pick<Transport, "request">) {
  const save = async (address: string, name: string) => {
    const response = await request(address, {});
    if (response.ok) {
      const type = response.headers.get("Content-Type") ?? "";
      saveText(name, type, await response.text());
    }
  };
  return (event: MouseEvent): void => {
    const link = (event.target as Element).closest("a");
    const address = link?.getAttribute("href") ?? "";
    if (link !== null && address.startsWith("/")) {
      event.preventDefault();
      const [path = ""] = address.split("?");
      const name = link.download || path.slice(path.lastIndexOf("/") + 1);
      void save(address, name).catch(() => undefined); // It is shown beside.
    }
  };
}
