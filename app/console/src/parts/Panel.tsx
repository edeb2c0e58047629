// SPDX-License-Identifier: Apache-2.0
import { useId, type ReactNode } from "react";
import { Boundary } from "./Boundary";

export interface PanelProperties {
  title: string;
  className?: string;
  children: ReactNode;
}

export function Panel({ title, className, children }: PanelProperties) {
  const id = useId();
  return (
    <section className={`panel ${className ?? ""}`} aria-labelledby={id}>
      <h2 id={id}>{title}</h2>
      <Boundary name="panel">{children}</Boundary>
    </section>
  );
}
