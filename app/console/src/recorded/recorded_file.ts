// SPDX-License-Identifier: Apache-2.0
// The file of a recording, read by the replay of the product: recorded.wasm, as site/recorded/recorded.h has it.

/** The exports of the module. */
interface Exports {
  memory: WebAssembly.Memory;
  name(): number;
  room(size: number): number;
  open(): number;
  goOn(records: number): number;
  document(): number;
  documentSize(): number;
  printed(): number;
}

type TakeShare = (share: number) => void;

const ALL = 1000;
const NAME_BYTES = 255;
/** Between two tellings how far it is. */
const RECORDS = 1000;

/** Why a browser gives none of them it does not say in plain words. */
export async function bytesOf(file: Blob): Promise<Uint8Array> {
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch (cause) {
    throw new Error(
      "It cannot be read: it is a folder, too large for this browser, or was moved or changed.",
      { cause },
    );
  }
}

export class RecordedFile {
  private readonly exported: Exports;

  /** The exports for one file. */
  constructor(module: WebAssembly.Module) {
    const { exports } = new WebAssembly.Instance(module, {});
    this.exported = exports as unknown as Exports;
  }

  /**
   * The content for a page, JSON in UTF-8. Throws the sentence of the replay for a refused file. `takeShare` gets the done share.
   *
   * @satisfies SWR-SITE-035
   * @satisfies SWR-SITE-036
   */
  read(
    name: string,
    file: Uint8Array,
    takeShare: TakeShare,
  ): Uint8Array<ArrayBuffer> {
    return this.said(() => {
      this.put(name, file);
      if (!this.exported.open()) {
        throw new Error("The file is refused.");
      }
      return this.finish(takeShare);
    });
  }

  /** Goes on with what is open. */
  finish(takeShare: TakeShare): Uint8Array<ArrayBuffer> {
    return this.said(() => {
      for (let done = 0; done < ALL; done = this.exported.goOn(RECORDS)) {
        takeShare(done / ALL);
      }
      const size = this.exported.documentSize();
      return this.bytes(this.exported.document()).slice(0, size);
    });
  }

  /** A failure has printed its reason. */
  private said<Result>(run: () => Result): Result {
    try {
      return run();
    } catch (cause) {
      throw new Error(this.printed || (cause as Error).message, { cause });
    }
  }

  private put(name: string, file: Uint8Array): void {
    // Addresses of the upper half come as numbers below zero.
    const at = this.exported.room(file.length) >>> 0;
    if (at === 0) {
      throw new Error("The file is too large for this page.");
    }
    this.bytes(at).set(file);
    const named = new TextEncoder().encode(name).subarray(0, NAME_BYTES);
    this.bytes(this.exported.name()).set(named);
  }

  private get printed(): string {
    const bytes = this.bytes(this.exported.printed());
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0))).trim();
  }

  private bytes(address: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.exported.memory.buffer, address);
  }
}
