// SPDX-License-Identifier: Apache-2.0
import { useState, type DragEvent } from "react";
import "./FileDrop.css";

export interface TextFile {
  name: string;
  text: string;
}

export interface FileDropProperties<Taken = TextFile> {
  /** Of the button that opens the file picker. */
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

/** One file, chosen or dragged here. */
export function AnyFileDrop({ label, accept, take }: FileDropProperties<File>) {
  const [isOver, setIsOver] = useState(false);
  const read = (file: File | undefined) => {
    if (file !== undefined) {
      take(file);
    }
  };
  const drop = (event: DragEvent) => {
    event.preventDefault();
    setIsOver(false);
    read(event.dataTransfer.files[0]);
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
      <span>or drag it here</span>
    </div>
  );
}
