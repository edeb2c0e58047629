/* SPDX-License-Identifier: Apache-2.0 */
/** @file How the cards of a box speak; its board knows. */
#ifndef BORESIGHT_CARD_DIALECT_H
#define BORESIGHT_CARD_DIALECT_H

#include "card/card_frame.h"

#include <stdint.h>

typedef enum {
    CARD_DIALECT_OWN = 0,  /**< card_frame.h. */
    CARD_DIALECT_AIM32 = 1 /**< aim32_frame.h: without most protections. */
} card_dialect_t;

/** Bytes of a frame that go over the wire. */
uint32_t card_dialect_frame_bytes(uint32_t dialect);

/** Writes `command` as the bytes of a frame of `dialect`, a card_dialect_t. */
void card_dialect_encode_command(uint32_t dialect, const card_command_t *command,
                                 uint8_t bytes[CARD_FRAME_BYTES]);

#endif
