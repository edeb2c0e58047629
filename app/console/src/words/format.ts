// SPDX-License-Identifier: Apache-2.0
import type { Origin } from "@interface";

export const units = { mm: "mm", deg: "°" } as const;
const MINUS = "\u2212";

export type Unit = keyof typeof units;

/** A fixed number of digits, so that numbers do not jump; a real minus sign, and none before zero. */
export function formatNumber(value: number, digits: number): string {
  const text = Math.abs(value).toFixed(digits);
  const isNegative = value < 0 && Number(text) !== 0;
  return isNegative ? MINUS + text : text;
}

export function formatValue(value: number, unit: Unit): string {
  return `${formatNumber(value, 2)} ${units[unit]}`;
}

export function formatSpeed(value: number, unit: Unit): string {
  return `${formatNumber(value, 1)} ${units[unit]}/s`;
}

export function formatPoint(point: readonly number[]): string {
  return point.map((value) => formatNumber(value, 2)).join(", ");
}

/** The origin of a homogeneous matrix by rows. */
export function originOf(matrix: readonly number[]): number[] {
  return [3, 7, 11].map((index) => matrix[index] ?? Number.NaN);
}

/** A homogeneous matrix in four lines, as other programs read it. */
export function matrixText(matrix: readonly number[]): string {
  return [0, 4, 8, 12]
    .map((row) => matrix.slice(row, row + 4).join(" "))
    .join("\n");
}

/** MOVE_TO_TARGET or back_off as people read it. */
export function words(name: string): string {
  return name.replaceAll("_", " ");
}

export function formatDuration(ms: number): string {
  const seconds = Math.floor(ms / 1000);
  if (seconds < 1) {
    return "under 1 s";
  }
  return seconds < 120 ? `${seconds} s` : `${Math.floor(seconds / 60)} min`;
}

/** 2 h 10 min. */
export function formatMinutes(minutes: number): string {
  const hours = Math.floor(minutes / 60);
  return hours === 0 ? `${minutes} min` : `${hours} h ${minutes % 60} min`;
}

/** The text behind a value that a client has sent; "" when its origin is unknown. */
export function formatOrigin(origin: Origin | null): string {
  if (origin === null) {
    return "";
  }
  const age = `${formatDuration(origin.age_s * 1000)} ago`;
  return `, from ${origin.name}, ${age.replaceAll(" ", "\u00a0")}`;
}

/** So many numbers by spaces, commas or lines; null if the text is anything else. */
export function readNumbers(text: string, count: number): number[] | null {
  const parts = text.split(/[\s,;]+/).filter((part) => part !== "");
  const numbers = parts.map((part) => Number(part.replace(MINUS, "-")));
  return numbers.length === count && numbers.every(Number.isFinite)
    ? numbers
    : null;
}

/** The text of a target as request fields. A quaternion names its parts, as programs differ in their order. */
export function readAim(text: string): Record<string, unknown> | null {
  const part = /([wxyz])\s*=\s*([^\s,;]+)/g;
  const matrix = readNumbers(text, 16);
  const point = readNumbers(text.replaceAll(part, ""), 3);
  const parts = [...text.matchAll(part)].map(
    ([, name = "", value = ""]) =>
      [name, Number(value.replace(MINUS, "-"))] as const,
  );
  if (matrix !== null || point === null) {
    return matrix && { matrix };
  }
  if (parts.length === 0) {
    return { point_mm: point };
  }
  const { w, x, y, z } = Object.fromEntries(parts);
  return parts.length === 4 && [w, x, y, z].every(Number.isFinite)
    ? { pose: { point_mm: point, w: w!, x: x!, y: y!, z: z! } }
    : null;
}

const CYCLES_PER_S = 1000;

/** Control's cycles since its start, as 1:02:03. */
export function formatCycles(cycles: number): string {
  const seconds = Math.floor(cycles / CYCLES_PER_S);
  const [minute, second] = [Math.floor(seconds / 60) % 60, seconds % 60].map(
    (part) => String(part).padStart(2, "0"),
  );
  return `${Math.floor(seconds / 3600)}:${minute}:${second}`;
}

/** 2026-11-22T17:50:00.123Z as people read it. */
export function formatUtc(utc: string): string {
  return utc.replace("T", " ").replace("Z", "");
}

const byteUnits = ["B", "kB", "MB", "GB", "TB"] as const;

/** In steps of 1000. */
export function formatBytes(bytes: number): string {
  let value = bytes;
  let step = 0;
  while (value >= 1000 && step < byteUnits.length - 1) {
    value /= 1000;
    step += 1;
  }
  return `${value.toFixed(step === 0 ? 0 : 1)} ${byteUnits[step]}`;
}
