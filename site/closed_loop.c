/* SPDX-License-Identifier: Apache-2.0 */
#include "site/closed_loop.h"

#include "control/lamps.h"
#include "limits/requirement_limits.h"

#include <stddef.h>
#include <string.h>

#define NS_PER_US UINT64_C(1000)

void closed_loop_init(closed_loop_t *self, const robot_t *robot, uint32_t seed)
{
    (void)memset(self, 0, sizeof *self);
    self->robot = robot;
    box_init(&self->box, robot, seed);
    controller_init(&self->controller, robot);
}

command_t *closed_loop_command(closed_loop_t *self)
{
    if (self->command_count == CONTROLLER_COMMANDS) {
        return NULL;
    }
    self->command_count++;
    return &self->commands[self->command_count - 1U];
}

/* The exchange that was begun in the cycle before, at its time. */
static bsp_exchange_t exchange(closed_loop_t *self)
{
    const uint64_t now_ns = self->time_us * NS_PER_US;
    /* C99 adds no const through an array pointer by itself. */
    const uint8_t(*const frames)[CARD_FRAME_BYTES] =
        (const uint8_t(*)[CARD_FRAME_BYTES])self->outputs.frames;

    bsp_exchange_t exchanged = {.started_ns = now_ns,
                                .finished_ns = now_ns,
                                .received = box_exchange(&self->box, self->outputs.frames_to_send,
                                                         frames, self->inputs.frames)};
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        exchanged.sampled_ns[slot] = now_ns;
    }
    return exchanged;
}

static void gather(closed_loop_t *self)
{
    (void)memset(&self->inputs, 0, sizeof self->inputs);
    const bsp_exchange_t exchanged = exchange(self);
    box_advance(&self->box, LIMIT_CYCLE_US);
    self->time_us += LIMIT_CYCLE_US;
    const bsp_inputs_t sampled = box_sample(&self->box);
    self->inputs.elapsed_us = LIMIT_CYCLE_US;
    board_inputs_take(&self->board_inputs, &sampled, &self->inputs);
    board_inputs_receive(&exchanged, &self->inputs);
    self->inputs.samples.error_us = LIMIT_SAMPLE_ERROR_SIM_US;
    self->inputs.command_count = self->command_count;
    (void)memcpy(self->inputs.commands, self->commands, sizeof self->inputs.commands);
}

void closed_loop_step(closed_loop_t *self)
{
    box_grip_look(&self->grip, &self->box, self->time_us);
    gather(self);
    self->command_count = 0U;
    (void)memset(self->commands, 0, sizeof self->commands);
    controller_step(&self->controller, self->robot, &self->inputs, &self->outputs);
    self->box.lamps = lamps_of(&self->outputs.snapshot);
}
