// SPDX-License-Identifier: Apache-2.0
import { Component, type ReactNode } from "react";

export interface BoundaryProperties {
  /** Name of the part that may fail, for the sentence. */
  name: string;
  /** The replacement for it; the sentence by default. */
  instead?: ReactNode;
  children: ReactNode;
}

/** A part of the page that fails leaves the others alone. */
export class Boundary extends Component<
  BoundaryProperties,
  { hasFailed: boolean }
> {
  override state = { hasFailed: false };

  static getDerivedStateFromError() {
    return { hasFailed: true };
  }

  override render() {
    if (!this.state.hasFailed) {
      return this.props.children;
    }
    return (
      this.props.instead ?? (
        <p className="panel-failed">
          This {this.props.name} cannot be shown. Reload the page; the robot is
          not affected.
        </p>
      )
    );
  }
}
