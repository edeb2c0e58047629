/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/lists/program_list.h"

#include "base/crc.h"
#include "robot/coupled_limit.h"
#include "robot/coupled_path.h"

#include <stddef.h>
#include <string.h>

uint32_t program_list_target_crc(const int32_t target_ticks[ROBOT_AXIS_MAX])
{
    return crc32c((const uint8_t *)target_ticks, ROBOT_AXIS_MAX * sizeof target_ticks[0]);
}

static uint32_t crc_of_head(const program_list_t *self)
{
    return crc32c((const uint8_t *)self, offsetof(program_list_t, seal));
}

static void clear(program_list_t *self)
{
    (void)memset(self, 0, sizeof *self);
}

status_t program_list_begin(program_list_t *self, uint32_t total, uint32_t source,
                            const int32_t target_ticks[ROBOT_AXIS_MAX])
{
    if (total > LIMIT_PROGRAM_STEPS) {
        return STATUS_OUT_OF_RANGE;
    }
    clear(self);
    self->total = total;
    self->source = source;
    self->target_crc = program_list_target_crc(target_ticks);
    self->seal = crc_of_head(self);
    return STATUS_OK;
}

void program_list_ends(const robot_t *robot, const int32_t target_ticks[ROBOT_AXIS_MAX],
                       const program_step_t *step, int32_t ends[ROBOT_AXIS_MAX])
{
    const uint32_t turning = program_step_turning_axis(robot);
    (void)memcpy(ends, target_ticks, ROBOT_AXIS_MAX * sizeof ends[0]);
    ends[robot->needle_axis] = step->depth_ticks;
    if (turning < robot->axis_count) {
        ends[turning] = step->angle_ticks;
    }
}

static solution_t judge_axis(const robot_t *robot, uint32_t axis, int32_t ticks)
{
    const axis_config_t *const config = &robot->axes[axis];
    solution_t result = {.status = STATUS_OK, .axis = (uint8_t)axis};
    result.is_maximum = (ticks > config->target_maximum_ticks) ? 1U : 0U;
    if ((ticks < config->minimum_ticks) || (ticks > config->maximum_ticks)) {
        result.status = STATUS_AXIS_LIMIT;
    } else if ((ticks < config->target_minimum_ticks) || (result.is_maximum != 0U)) {
        result.status = STATUS_SWITCH_ZONE;
    } else {
        result.status = STATUS_OK;
    }
    return result;
}

/* Judges the positions at it, and the way there from the step before. */
static solution_t judge_way(const robot_t *robot, const int32_t target_ticks[ROBOT_AXIS_MAX],
                            const program_step_t *before, const program_step_t *step)
{
    int32_t from[ROBOT_AXIS_MAX];
    int32_t to[ROBOT_AXIS_MAX];
    joints_t joints;
    program_list_ends(robot, target_ticks, before, from);
    program_list_ends(robot, target_ticks, step, to);
    joints_from_ticks(robot, to, &joints);
    const solution_t result = coupled_limit_judge(robot, &joints);
    return (result.status == STATUS_OK) ? coupled_path_judge(robot, from, to) : result;
}

static solution_t judge_place(const robot_t *robot, const int32_t target_ticks[ROBOT_AXIS_MAX],
                              const program_step_t *step)
{
    const uint32_t turning = program_step_turning_axis(robot);
    solution_t result = {
        .status = STATUS_PROGRAM_DEPTH, .axis = (uint8_t)robot->needle_axis, .is_maximum = 1U};
    if (step->depth_ticks <= target_ticks[robot->needle_axis]) {
        result = judge_axis(robot, robot->needle_axis, step->depth_ticks);
    }
    if ((result.status == STATUS_OK) && (turning < robot->axis_count)) {
        result = judge_axis(robot, turning, step->angle_ticks);
    }
    return result;
}

static solution_t judge(const program_list_t *self, const robot_t *robot,
                        const int32_t target_ticks[ROBOT_AXIS_MAX], const program_step_t *step)
{
    const program_step_t *const before =
        (self->count == 0U) ? step : &self->steps[self->count - 1U];
    solution_t result = {.status = STATUS_OK};
    if (self->target_crc != program_list_target_crc(target_ticks)) {
        result.status = STATUS_PROGRAM_OTHER;
    } else if ((step->dwell_ms > LIMIT_PROGRAM_DWELL_MS) ||
               ((step->is_gated != 0U) && (step->dwell_ms == 0U))) {
        result.status = STATUS_PROGRAM_DWELL;
    } else {
        result = judge_place(robot, target_ticks, step);
    }
    return (result.status == STATUS_OK) ? judge_way(robot, target_ticks, before, step) : result;
}

static bool is_filled_next(const program_list_t *self, uint32_t index)
{
    return (self->seal == crc_of_head(self)) && (index == self->count) && (index < self->total);
}

solution_t program_list_add(program_list_t *self, const robot_t *robot,
                            const int32_t target_ticks[ROBOT_AXIS_MAX], uint32_t index,
                            const program_step_t *step)
{
    solution_t result = {.status = STATUS_PROGRAM_ORDER};
    if (is_filled_next(self, index)) {
        result = judge(self, robot, target_ticks, step);
    }
    if (result.status != STATUS_OK) {
        clear(self);
        return result;
    }
    self->steps[index] = *step;
    self->steps[index].crc = program_step_crc(step);
    self->crc = program_list_crc(self->crc, step);
    self->count++;
    self->seal = crc_of_head(self);
    return result;
}

/* Checksum of the steps as they are now. */
static uint32_t crc_of_all(const program_list_t *self)
{
    uint32_t crc = 0U;
    for (uint32_t i = 0U; i < self->count; i++) {
        crc = program_list_crc(crc, &self->steps[i]);
    }
    return crc;
}

status_t program_list_end(program_list_t *self, uint32_t crc)
{
    const bool is_full = (self->seal == crc_of_head(self)) && (self->total != 0U) &&
                         (self->count == self->total) && (self->crc == crc);
    if (!is_full) {
        clear(self);
        return STATUS_PROGRAM_ORDER;
    }
    self->is_whole = 1U;
    self->seal = crc_of_head(self);
    return STATUS_OK;
}

bool program_list_is_meant(const program_list_t *self, uint32_t crc,
                           const int32_t target_ticks[ROBOT_AXIS_MAX])
{
    return (self->seal == crc_of_head(self)) && (self->is_whole != 0U) && (self->crc == crc) &&
           (self->target_crc == program_list_target_crc(target_ticks)) && (crc_of_all(self) == crc);
}

const program_step_t *program_list_step(const program_list_t *self, uint32_t index)
{
    const program_step_t *found = NULL;
    if ((self->seal == crc_of_head(self)) && (self->is_whole != 0U) && (index < self->count) &&
        program_step_is_whole(&self->steps[index])) {
        found = &self->steps[index];
    }
    return found;
}
