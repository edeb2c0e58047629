// SPDX-License-Identifier: Apache-2.0
import type { Box } from "@interface";

/** A card without an axis reads the load cells of hand and needle. */
export function hasForceSensor({ slots }: Box): boolean {
  return slots.some(({ card_type }) => card_type === "sensor");
}
