// SPDX-License-Identifier: Apache-2.0
// The worker that reads one recording.
import { moduleOf } from "../site/packed";
import type { Order, Report } from "./messages";
import { bytesOf, RecordedFile } from "./recorded_file";

const send = (report: Report) => postMessage(report);

async function read({ packed, file }: Order): Promise<void> {
  const recorded = new RecordedFile(await moduleOf(packed));
  const bytes = await bytesOf(file);
  const document = recorded.read(file.name, bytes, (share) =>
    send({ kind: "share", share }),
  );
  postMessage({ kind: "read", document } satisfies Report, {
    transfer: [document.buffer],
  });
}

addEventListener("message", ({ data }: MessageEvent<Order>) => {
  read(data).catch(({ message }: Error) =>
    send({ kind: "refused", reason: message }),
  );
});
