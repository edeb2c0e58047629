// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState } from "react";
import type { KeyboardEvent, PointerEvent, SVGProps } from "react";
import type { Axis } from "@interface";
import { formatValue } from "../words/format";
import { isKnown } from "../state/trust";
import { percentOf } from "./drawn/Track";
import "./Slider.css";

const DIGITS = 2;
const PAGE_STEPS = 10;

const steps: Readonly<Record<string, number>> = {
  ArrowLeft: -1,
  ArrowDown: -1,
  ArrowRight: 1,
  ArrowUp: 1,
  PageDown: -PAGE_STEPS,
  PageUp: PAGE_STEPS,
};

function within(axis: Axis, position: number): number {
  const rounded = Number(position.toFixed(DIGITS));
  return Math.min(axis.maximum, Math.max(axis.minimum, rounded));
}

interface Drag {
  /** Where it was taken, on the screen and on the axis. */
  x: number;
  position: number;
}

/** Slider of a set-point, which is sent when the slider is let go. */
function useDraft({ axis, asked, isLocked, onSend }: SliderProperties) {
  const [draft, setDraft] = useState<number | null>(null);
  const dragRef = useRef<Drag | null>(null);
  const wanted = draft ?? asked ?? axis.setpoint;
  const discard = () => {
    dragRef.current = null;
    setDraft(null);
  };
  useEffect(() => {
    if (isLocked) {
      discard();
    }
  }, [isLocked]);
  const letGo = () => {
    discard();
    if (draft !== null && !isLocked) {
      onSend(draft);
    }
  };
  const put = (position: number) => setDraft(within(axis, position));
  const take = (event: PointerEvent<SVGElement>) => {
    if (!isLocked && event.button === 0) {
      event.currentTarget.setPointerCapture(event.pointerId);
      dragRef.current = { x: event.clientX, position: wanted };
    }
  };
  /** `width`: of the axis, on the screen. */
  const pull = (event: PointerEvent, width: number) => {
    if (dragRef.current !== null && width > 0) {
      const way = (event.clientX - dragRef.current.x) / width;
      const range = axis.maximum - axis.minimum;
      put(dragRef.current.position + way * range);
    }
  };
  return { draft, wanted, put, discard, letGo, take, pull };
}

export interface SliderProperties {
  axis: Axis;
  /** Position that this page has asked for and control has not reached yet. */
  asked: number | null;
  /** Step of an arrow key, in the unit of the axis. */
  step: number;
  isLocked: boolean;
  /** It was let go. */
  onSend: (position: number) => void;
}

function SliderTrack({
  axis,
  wanted,
  grip,
}: {
  axis: Axis;
  wanted: number;
  /** Handlers of the pointer on the circle. */
  grip: SVGProps<SVGCircleElement>;
}) {
  const at = (position: number) => `${percentOf(axis, position)}%`;
  return (
    <svg className="track" aria-hidden="true">
      <line className="track-line" x1="0" x2="100%" y1="50%" y2="50%" />
      <line className="track-limit" x1="0" x2="0" y1="25%" y2="75%" />
      <line className="track-limit" x1="100%" x2="100%" y1="25%" y2="75%" />
      {isKnown(axis) && (
        <>
          <line
            className="slider-accepted"
            x1={at(axis.setpoint)}
            x2={at(axis.setpoint)}
            y1="10%"
            y2="90%"
          />
          <svg
            className="track-position"
            x={at(axis.position)}
            y="50%"
            overflow="visible"
          >
            <path d="M0-6L6 0 0 6-6 0z" />
          </svg>
          <circle className="track-setpoint" cx={at(wanted)} cy="50%" r="10" />
          <circle
            className="slider-grip"
            cx={at(wanted)}
            cy="50%"
            r="16"
            {...grip}
          />
        </>
      )}
    </svg>
  );
}

/**
 * Circle: what this page asks for. Tick: where control wants the axis now. Diamond: where it is. The circle is taken by
 * the pointer or moved by keys, and only what it is let go at is sent.
 *
 * @satisfies SWR-CON-025
 */
export function Slider(properties: SliderProperties) {
  const { axis, step, isLocked } = properties;
  const frame = useRef<HTMLDivElement>(null);
  const { draft, wanted, put, discard, letGo, take, pull } =
    useDraft(properties);
  const value = (position: number) => formatValue(position, axis.unit);

  const press = (event: KeyboardEvent) => {
    const count = steps[event.key];
    if (event.key === "Escape") {
      discard(); // It stops as well, but that is not done here.
    } else if (count !== undefined) {
      event.preventDefault();
      if (!isLocked) {
        put(wanted + count * step);
      }
    }
  };
  return (
    <div
      className="slider"
      ref={frame}
      role="slider"
      tabIndex={0}
      aria-label={`Set-point of ${axis.name}`}
      aria-valuemin={axis.minimum}
      aria-valuemax={axis.maximum}
      aria-valuenow={wanted}
      aria-valuetext={
        isKnown(axis)
          ? `${value(wanted)}${draft === null ? "" : ", not sent"}, position ${value(axis.position)}`
          : "unknown"
      }
      aria-disabled={isLocked}
      data-drafted={draft !== null}
      data-known={isKnown(axis)}
      onKeyDown={press}
      onKeyUp={(event) => event.key in steps && letGo()}
      onBlur={discard}
    >
      <SliderTrack
        axis={axis}
        wanted={wanted}
        grip={{
          onPointerDown: take,
          onPointerMove: (event) =>
            pull(event, frame.current?.getBoundingClientRect().width ?? 0),
          onPointerUp: letGo,
          onPointerCancel: discard,
        }}
      />
    </div>
  );
}
