/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/jog/jog_mode.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"

#include <stdbool.h>

static solution_t judge_homed(const mode_way_t *asked, const robot_t *robot,
                              const axis_t axes[ROBOT_AXIS_MAX])
{
    const axis_config_t *const config = &robot->axes[asked->axis];
    solution_t result = {.status = STATUS_OK, .axis = (uint8_t)asked->axis, .is_maximum = 0U};
    if ((asked->end_ticks < config->minimum_ticks) || (asked->end_ticks > config->maximum_ticks)) {
        result.status = STATUS_AXIS_LIMIT;
        result.is_maximum = (asked->end_ticks > config->maximum_ticks) ? 1U : 0U;
    } else if ((asked->end_ticks < config->target_minimum_ticks) ||
               (asked->end_ticks > config->target_maximum_ticks)) {
        result.status = STATUS_SWITCH_ZONE;
    } else {
        result = coupled_guard_judge(robot, axes, asked->axis, asked->end_ticks);
    }
    return result;
}

/* A short way only. */
static status_t judge_unknown(const axis_config_t *config, int64_t way_ticks)
{
    const int64_t most_ticks =
        joints_ticks_within(config, LIMIT_UNHOMED_JOG_NM, LIMIT_UNHOMED_JOG_BAM);
    return (fixed_magnitude(way_ticks) <= most_ticks) ? STATUS_OK : STATUS_JOG_TOO_FAR;
}

solution_t jog_mode_judge(const mode_way_t *asked, const robot_t *robot,
                          const axis_t axes[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_UNKNOWN_COMMAND, .axis = 0U, .is_maximum = 0U};
    if (asked->axis >= robot->axis_count) {
        return result;
    }
    const axis_t *const axis = &axes[asked->axis];
    const int64_t way_ticks =
        (int64_t)asked->end_ticks - (int64_t)axis->sealed.encoder.position_ticks;
    result.status = STATUS_OK;
    if (needle_forbids_jog(robot, axes, asked->axis, way_ticks > 0)) {
        result.status = STATUS_NEEDLE_IN;
    } else if (axis_is_homed(axis)) {
        result = judge_homed(asked, robot, axes);
    } else {
        /* Its limits mean nothing yet. */
    }
    if ((result.status == STATUS_OK) && !coupled_guard_is_known(robot, axes, asked->axis)) {
        result.status = judge_unknown(&robot->axes[asked->axis], way_ticks);
    }
    return result;
}

void jog_mode_step(const mode_way_t *self, leg_t *leg, const mode_frame_t *frame,
                   mode_result_t *result)
{
    if (leg->is_running == 0U) {
        int32_t ends[ROBOT_AXIS_MAX] = {0};
        const uint32_t axis = self->axis % ROBOT_AXIS_MAX;
        ends[axis] = self->end_ticks;
        leg_begin(leg, frame, (axis == self->axis) ? LEG_AXIS(axis) : 0U, ends);
    }
    if (leg_step(leg, frame, result)) {
        result->progress = MODE_DONE;
    }
}

uint32_t jog_mode_ask(const mode_asked_t *asked, mode_way_t *way)
{
    if (asked->command->kind == (uint32_t)COMMAND_JOG) {
        const command_jog_t *const sent = command_as_jog(asked->command);
        *way = (mode_way_t){.axis = sent->axis, .end_ticks = sent->to_ticks};
    } else {
        const command_jog_by_t *const sent = command_as_jog_by(asked->command);
        *way = (mode_way_t){.axis = sent->axis, .end_ticks = 0};
        if (sent->axis < asked->robot->axis_count) {
            const int32_t from_ticks = asked->axes[sent->axis].sealed.encoder.position_ticks;
            way->end_ticks = fixed_saturate((int64_t)from_ticks + (int64_t)sent->by_ticks);
        }
    }
    return mode_asked_axes(way->axis);
}
