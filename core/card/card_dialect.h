/* SPDX-License-Identifier: Apache-2.0 */
/** @file How the cards of a box speak; its board knows. */
#ifndef BORESIGHT_CARD_DIALECT_H
#define BORESIGHT_CARD_DIALECT_H

#include "card/aim32_frame.h"
#include "card/card_frame.h"

#include <stdint.h>

typedef enum {
    CARD_DIALECT_OWN = 0,  /**< card_frame.h. */
    CARD_DIALECT_AIM32 = 1 /**< aim32_frame.h: without most protections. */
} card_dialect_t;

/** Bytes of a frame that go over the wire. */
static inline uint32_t card_dialect_frame_bytes(uint32_t dialect)
{
    return (dialect == (uint32_t)CARD_DIALECT_OWN) ? CARD_FRAME_BYTES : AIM32_FRAME_BYTES;
}

/** Writes `command` as the bytes of a frame of `dialect`, a card_dialect_t. */
static inline void card_dialect_encode_command(uint32_t dialect, const card_command_t *command,
                                               uint8_t bytes[CARD_FRAME_BYTES])
{
    if (dialect == (uint32_t)CARD_DIALECT_OWN) {
        card_frame_encode_command(command, bytes);
    } else {
        aim32_frame_encode_command(command, bytes);
    }
}

#endif
