/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/cycle/controller_dialect.h"

#include "card/aim32_frame.h"
#include "card/card_dialect.h"

static void translate(uint32_t slot, uint8_t bytes[CARD_FRAME_BYTES])
{
    card_command_t command = {.slot = slot};

    (void)card_frame_decode_command(bytes, slot, &command);
    aim32_frame_encode_command(&command, bytes);
}

void controller_translate(const cycle_t *cycle)
{
    controller_outputs_t *const outputs = cycle->outputs;

    if (cycle->inputs->dialect == (uint32_t)CARD_DIALECT_OWN) {
        return;
    }
    for (uint32_t slot = 0U; (outputs->frames_to_send >> slot) != 0U; slot++) {
        if (((outputs->frames_to_send >> slot) & 1U) != 0U) {
            translate(slot, outputs->frames[slot]);
        }
    }
}
