/* SPDX-License-Identifier: Apache-2.0 */
#include "card/card_dialect.h"

#include "card/aim32_frame.h"

uint32_t card_dialect_frame_bytes(uint32_t dialect)
{
    return (dialect == (uint32_t)CARD_DIALECT_OWN) ? CARD_FRAME_BYTES : AIM32_FRAME_BYTES;
}

void card_dialect_encode_command(uint32_t dialect, const card_command_t *command,
                                 uint8_t bytes[CARD_FRAME_BYTES])
{
    if (dialect == (uint32_t)CARD_DIALECT_OWN) {
        card_frame_encode_command(command, bytes);
    } else {
        aim32_frame_encode_command(command, bytes);
    }
}
