/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_jog.h"

#include "safety/coupled_guard.h"
#include "safety/needle.h"

static status_t judge_homed(const controller_t *self, const robot_t *robot,
                            const command_t *command, answer_t *answer)
{
    const axis_config_t *const config = &robot->axes[command->argument];
    const coupled_side_t side =
        coupled_guard_judge(robot, self->axes, command->argument, command->value);
    bool is_maximum = false;
    status_t status = STATUS_OK;
    if ((command->value < config->minimum_ticks) || (command->value > config->maximum_ticks)) {
        is_maximum = command->value > config->maximum_ticks;
        status = STATUS_AXIS_LIMIT;
    } else if ((command->value < config->target_minimum_ticks) ||
               (command->value > config->target_maximum_ticks)) {
        status = STATUS_SWITCH_ZONE;
    } else if (side != COUPLED_LIMIT_INSIDE) {
        is_maximum = side == COUPLED_LIMIT_ABOVE;
        status = STATUS_SEPARATION_LIMIT;
    } else {
        return STATUS_OK;
    }
    answer->axis = command->argument;
    if (is_maximum) {
        answer->is_maximum = 1U;
    }
    return status;
}

/* A short way only. */
static status_t judge_unknown(const axis_config_t *config, int64_t way_ticks)
{
    const int64_t most = (config->unit == (uint8_t)AXIS_UNIT_MM) ? (int64_t)LIMIT_UNHOMED_JOG_NM
                                                                 : (int64_t)LIMIT_UNHOMED_JOG_BAM;
    const int64_t most_ticks = (most * 65536) / config->unit_per_tick_q16;
    return ((way_ticks <= most_ticks) && (way_ticks >= -most_ticks)) ? STATUS_OK
                                                                     : STATUS_JOG_TOO_FAR;
}

status_t controller_judge_jog(const controller_t *self, const robot_t *robot,
                              const command_t *command, answer_t *answer)
{
    if (command->argument >= robot->axis_count) {
        return STATUS_UNKNOWN_COMMAND;
    }
    const axis_t *const axis = &self->axes[command->argument];
    const int64_t way_ticks = (int64_t)command->value - (int64_t)axis->encoder.position_ticks;
    status_t status = STATUS_OK;
    if (needle_forbids_jog(robot, self->axes, command->argument, way_ticks > 0)) {
        status = STATUS_NEEDLE_IN;
    } else if (axis_is_homed(axis)) {
        status = judge_homed(self, robot, command, answer);
    } else {
        /* Its limits mean nothing yet. */
    }
    if ((status == STATUS_OK) && !coupled_guard_is_known(robot, self->axes, command->argument)) {
        status = judge_unknown(&robot->axes[command->argument], way_ticks);
    }
    return status;
}
