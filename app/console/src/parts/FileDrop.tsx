// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState, type DragEvent } from "react";
import "./FileDrop.css";

export interface TextFile {
  name: string;
  text: string;
}

export interface FileDropProperties<Taken = TextFile> {
  /** Label of the button that opens the file picker. */
  label: string;
  /** As the file picker takes it. */
  accept: string;
  take(file: Taken): void;
}

/** One file of text. It is read, and goes nowhere by itself. */
export function FileDrop({ take, ...drop }: FileDropProperties) {
  const read = (file: File) =>
    void file.text().then((text) => take({ name: file.name, text }));
  return <AnyFileDrop {...drop} take={read} />;
}

/** A file that is dropped beside it would replace the page. */
function refuseBeside(event: globalThis.DragEvent): void {
  if (!event.defaultPrevented) {
    event.preventDefault();
    if (event.dataTransfer !== null) {
      event.dataTransfer.dropEffect = "none";
    }
  }
}

function useNothingBeside(): void {
  useEffect(() => {
    const kinds = ["dragover", "drop"] as const;
    kinds.forEach((kind) => addEventListener(kind, refuseBeside));
    return () =>
      kinds.forEach((kind) => removeEventListener(kind, refuseBeside));
  }, []);
}

/** One file, chosen or dragged here. */
export function AnyFileDrop({ label, accept, take }: FileDropProperties<File>) {
  const [isOver, setIsOver] = useState(false);
  const [dropped, setDropped] = useState(1);
  useNothingBeside();
  const read = (file: File | undefined) => {
    if (file !== undefined) {
      setDropped(1);
      take(file);
    }
  };
  const drop = (event: DragEvent) => {
    event.preventDefault();
    setIsOver(false);
    const { files } = event.dataTransfer;
    if (files.length > 1) {
      setDropped(files.length);
    } else {
      read(files[0]);
    }
  };
  return (
    <div
      className="file-drop"
      data-over={isOver}
      onDragOver={(event) => {
        event.preventDefault();
        setIsOver(true);
      }}
      onDragLeave={() => setIsOver(false)}
      onDrop={drop}
    >
      <label>
        {label}
        <input
          className="hidden"
          type="file"
          accept={accept}
          onChange={(event) => {
            read(event.target.files?.[0]);
            event.target.value = ""; // The same file, altered, is a change again.
          }}
        />
      </label>
      <span role="status">
        {dropped > 1
          ? `None of the ${dropped} files was taken: drag one here`
          : "or drag it here"}
      </span>
    </div>
  );
}
