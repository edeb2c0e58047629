/* SPDX-License-Identifier: Apache-2.0 */
/** @file What people call the frames that cards are sent and understood in. */
#ifndef BORESIGHT_CARD_PROTOCOL_H
#define BORESIGHT_CARD_PROTOCOL_H

#include "card/card_dialect.h"

#include <stdint.h>
#include <stdio.h>

#define CARD_PROTOCOL_SIZE 12U

/** Writes the version of Boresight's own frames, or the name of another dialect. */
static inline void card_protocol_write(uint32_t dialect, char text[CARD_PROTOCOL_SIZE])
{
    if (dialect == (uint32_t)CARD_DIALECT_OWN) {
        (void)snprintf(text, CARD_PROTOCOL_SIZE, "%u", CARD_FRAME_PROTOCOL);
    } else {
        (void)snprintf(text, CARD_PROTOCOL_SIZE, "aim32");
    }
}

#endif
