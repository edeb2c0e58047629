// SPDX-License-Identifier: Apache-2.0
import { Component, useId, type ReactNode } from "react";

interface BoundaryState {
  hasFailed: boolean;
}

/** A panel that fails says so and leaves the others alone. */
class PanelBoundary extends Component<{ children: ReactNode }, BoundaryState> {
  override state: BoundaryState = { hasFailed: false };

  static getDerivedStateFromError(): BoundaryState {
    return { hasFailed: true };
  }

  override render() {
    return this.state.hasFailed ? (
      <p className="panel-failed">
        This panel cannot be shown. Reload the page; the robot is not affected.
      </p>
    ) : (
      this.props.children
    );
  }
}

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
      <PanelBoundary>{children}</PanelBoundary>
    </section>
  );
}
