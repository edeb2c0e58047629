/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/box.h"
#include "sim/box_needle.h"

#include <string.h>

void box_show(const box_t *self, bsp_bench_t *seen)
{
    (void)memset(seen, 0, sizeof *seen);
    seen->pedal_holder = self->holds[BOX_HELD_PEDAL].holder;
    seen->button_holder = self->holds[BOX_HELD_BUTTON].holder;
    seen->hand_holder = self->holds[BOX_HELD_HAND].holder;
    seen->is_hand_pressed = self->force.hand.act != SIM_HAND_OFF;
    seen->grip_mn = self->force.grip_mn;
    seen->layers = self->force.phantom.tissue.layer_count;
    seen->force_hand = (uint32_t)self->force.cells[SIM_CELL_HAND].fault;
    seen->force_needle = (uint32_t)self->force.cells[SIM_CELL_NEEDLE].fault;
    seen->gate = (uint32_t)self->gate;
    seen->is_probe_free = self->probe.is_free ? 1U : 0U;
    box_needle_show(self, &seen->needle);
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const box_axis_t *const axis = &self->axes[i];
        seen->slots[axis->config->slot] =
            (bsp_bench_slot_t){.card_type = axis->config->card_type,
                               .has_axis = 1U,
                               .card_fault = (uint8_t)axis->card_fault,
                               .encoder_fault = (uint8_t)axis->encoder.fault,
                               .motor_fault = (uint8_t)axis->motor.fault,
                               .switch_fault = (uint8_t)axis->limit_switch.fault};
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const box_sensor_t *const sensor = &self->sensors[slot];
        if (((self->sensor_slots >> slot) & 1U) != 0U) {
            seen->slots[slot] = (bsp_bench_slot_t){.card_type = (uint8_t)sensor->card.card_type,
                                                   .card_fault = (uint8_t)sensor->card_fault};
        }
    }
}
