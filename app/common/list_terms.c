/* SPDX-License-Identifier: Apache-2.0 */
#include "common/list_terms.h"

#include "common/axis_terms.h"

#include <math.h>
#include <string.h>

#define MS_PER_S 1000.0
#define MOST_S 1.0e6

status_t list_terms_step(const robot_t *robot, const reported_step_t *reported,
                         program_step_t *step)
{
    const uint32_t turning = program_step_turning_axis(robot);
    const bool is_turning = turning < robot->axis_count;

    (void)memset(step, 0, sizeof *step);
    if ((reported->has_angle != is_turning) || (reported->dwell_s < 0.0) ||
        (reported->dwell_s > MOST_S) ||
        !axis_terms_ticks(&robot->axes[robot->needle_axis], reported->depth_mm,
                          &step->depth_ticks) ||
        (is_turning &&
         !axis_terms_ticks(&robot->axes[turning], reported->angle_deg, &step->angle_ticks))) {
        return STATUS_OUT_OF_RANGE;
    }
    step->dwell_ms = (uint32_t)round(reported->dwell_s * MS_PER_S);
    step->is_gated = reported->is_gated ? 1U : 0U;
    return (reported->is_gated && (step->dwell_ms == 0U)) ? STATUS_PROGRAM_DWELL : STATUS_OK;
}

command_t list_terms_step_command(const robot_t *robot, uint32_t index, const program_step_t *step)
{
    const uint32_t turning = program_step_turning_axis(robot);
    command_t command = {
        .kind = (uint32_t)COMMAND_PROGRAM_STEP,
        .as.step = {.index = index, .dwell_ms = step->dwell_ms, .is_gated = step->is_gated}};

    command.as.step.ticks[robot->needle_axis] = step->depth_ticks;
    if (turning < robot->axis_count) {
        command.as.step.ticks[turning] = step->angle_ticks;
    }
    return command;
}

command_t list_terms_row_command(uint32_t index, const trajectory_row_t *row)
{
    command_t command = {.kind = (uint32_t)COMMAND_LIST_ROW,
                         .as.row = {.index = index, .time_ms = row->time_ms}};

    (void)memcpy(command.as.row.ticks, row->ticks, sizeof row->ticks);
    (void)memcpy(command.as.row.speeds_ticks_per_s, row->speeds_ticks_per_s,
                 sizeof row->speeds_ticks_per_s);
    return command;
}
