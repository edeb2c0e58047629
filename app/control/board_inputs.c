/* SPDX-License-Identifier: Apache-2.0 */
#include "control/board_inputs.h"

#include "interface/box_input.h"

#include <stdbool.h>
#include <string.h>

#define NS_PER_US 1000U

static uint32_t flag(bool is_set)
{
    return is_set ? 1U : 0U;
}

/* Bits of box_input_t that are not read. A box may have no gate. */
static uint32_t unread_of(const board_inputs_t *self, uint32_t valid)
{
    static const uint32_t inputs[BOX_INPUT_COUNT] = {
        [BOX_INPUT_PEDAL] = BSP_IN_PEDAL_A | BSP_IN_PEDAL_B,
        [BOX_INPUT_ESTOP] = BSP_IN_ESTOP_CHAIN,
        [BOX_INPUT_SCANNER] = BSP_IN_SCANNER_IDLE,
        [BOX_INPUT_GATE] = BSP_IN_DOSE_BELOW | BSP_IN_TREATMENT_MAY};
    const uint32_t there =
        self->known | BSP_IN_PEDAL_A | BSP_IN_PEDAL_B | BSP_IN_ESTOP_CHAIN | BSP_IN_SCANNER_IDLE;
    uint32_t unread = 0U;

    for (uint32_t i = 0U; i < (uint32_t)BOX_INPUT_COUNT; i++) {
        const bool is_missing = (inputs[i] & there & ~valid) != 0U;
        unread |= is_missing ? ((uint32_t)1U << i) : 0U;
    }
    return unread;
}

void board_inputs_take(board_inputs_t *self, const bsp_inputs_t *sampled,
                       controller_inputs_t *inputs)
{
    const uint32_t levels = sampled->levels & ~sampled->dropped & sampled->valid;

    self->known |= sampled->valid;
    const uint32_t low = self->known & ~levels;
    inputs->pedal_a = flag((levels & BSP_IN_PEDAL_A) != 0U);
    inputs->pedal_b = flag((levels & BSP_IN_PEDAL_B) != 0U);
    inputs->estop_open = flag((levels & BSP_IN_ESTOP_CHAIN) == 0U);
    inputs->scanner_active = flag((levels & BSP_IN_SCANNER_IDLE) == 0U);
    inputs->has_button = flag((self->known & BSP_IN_CONFIRM) != 0U);
    inputs->confirm_pressed = flag((levels & BSP_IN_CONFIRM) != 0U);
    inputs->dose_reached = flag((low & BSP_IN_DOSE_BELOW) != 0U);
    inputs->treatment_stopped = flag((low & BSP_IN_TREATMENT_MAY) != 0U);
    inputs->unread = unread_of(self, sampled->valid);
}

/* Bits of the slots with this result. */
static uint32_t slots_of(const bsp_exchange_t *exchanged, bsp_slot_result_t result)
{
    uint32_t slots = 0U;

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        slots |= (exchanged->results[slot] == (uint8_t)result) ? ((uint32_t)1U << slot) : 0U;
    }
    return slots;
}

void board_inputs_receive(const bsp_exchange_t *exchanged, controller_inputs_t *inputs)
{
    inputs->frames_received = exchanged->received;
    inputs->frames_late =
        slots_of(exchanged, BSP_SLOT_LATE) | slots_of(exchanged, BSP_SLOT_NOT_IDLE);
    inputs->frames_failed = slots_of(exchanged, BSP_SLOT_BUS_ERROR);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        inputs->samples.sampled_us[slot] = (uint32_t)(exchanged->sampled_ns[slot] / NS_PER_US);
    }
}

void board_inputs_note(const bsp_inputs_t *sampled, const bsp_exchange_t *exchanged,
                       cycle_board_t *said)
{
    *said = (cycle_board_t){.sampled_us = (uint32_t)(sampled->sampled_ns / NS_PER_US),
                            .levels = sampled->levels,
                            .dropped = sampled->dropped,
                            .valid = sampled->valid,
                            .started_us = (uint32_t)(exchanged->started_ns / NS_PER_US),
                            .finished_us = (uint32_t)(exchanged->finished_ns / NS_PER_US),
                            .error = exchanged->error};
    (void)memcpy(said->results, exchanged->results, sizeof said->results);
}
