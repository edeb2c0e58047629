/* SPDX-License-Identifier: Apache-2.0 */
#include "control/board_inputs.h"

#include <stdbool.h>

static uint32_t flag(bool is_set)
{
    return is_set ? 1U : 0U;
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
}
