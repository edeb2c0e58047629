// SPDX-License-Identifier: Apache-2.0
import { useRef, type KeyboardEvent, type PointerEvent } from "react";

function isPressKey({ key }: KeyboardEvent): boolean {
  return key === " " || key === "Enter";
}

export interface HoldButtonProperties {
  label: string;
  isHeld: boolean;
  isDisabled: boolean;
  onHold: () => void;
  onDrop: () => void;
}

/**
 * A button for as long as pointer or key is down on it. Each loss of either is a release, also when another finger or
 * key has come meanwhile.
 */
export function HoldButton({
  label,
  isHeld,
  isDisabled,
  onHold,
  onDrop,
}: HoldButtonProperties) {
  const isDown = useRef(false);
  const press = () => {
    if (!isHeld) {
      isDown.current = true;
      onHold();
    }
  };
  const release = () => {
    if (isDown.current) {
      isDown.current = false;
      onDrop();
    }
  };
  const point = (event: PointerEvent<HTMLButtonElement>) => {
    if (event.button === 0) {
      event.currentTarget.setPointerCapture(event.pointerId);
      press();
    }
  };
  return (
    <button
      type="button"
      className="hold-button"
      disabled={isDisabled}
      aria-pressed={isHeld}
      onPointerDown={point}
      onPointerUp={release}
      onPointerCancel={release}
      onLostPointerCapture={release}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (isPressKey(event)) {
          event.preventDefault();
          if (!event.repeat) {
            press();
          }
        }
      }}
      onKeyUp={release}
      onBlur={release}
    >
      {label}
    </button>
  );
}
