/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/lists/trajectory_list.h"

#include "robot/coupled_limit.h"
#include "robot/coupled_path.h"
#include "safety/needle.h"

#include <string.h>

/* The ways of all axes between two rows, by their control points. */
typedef struct {
    int32_t ticks[CUBIC_POINTS][ROBOT_AXIS_MAX];
} hull_t;

void trajectory_list_clear(trajectory_list_t *self)
{
    (void)memset(self, 0, sizeof *self);
}

status_t trajectory_list_begin(trajectory_list_t *self, uint32_t total)
{
    if (total > LIMIT_TRAJECTORY_ROWS) {
        return STATUS_OUT_OF_RANGE;
    }
    trajectory_list_clear(self);
    self->total = total;
    return STATUS_OK;
}

void trajectory_list_way(const trajectory_row_t *from, const trajectory_row_t *to, uint32_t axis,
                         cubic_t *way)
{
    const cubic_end_t begin = {.ticks = from->ticks[axis],
                               .speed_ticks_per_s = from->speeds_ticks_per_s[axis]};
    const cubic_end_t end = {.ticks = to->ticks[axis],
                             .speed_ticks_per_s = to->speeds_ticks_per_s[axis]};
    const uint32_t span_ms = to->time_ms - from->time_ms;
    cubic_set(way, &begin, &end, (span_ms == 0U) ? 1U : span_ms);
}

static int32_t highest_speed(const axis_config_t *config)
{
    const int64_t speed =
        ((int64_t)config->speed_ticks_per_s * (int64_t)LIMIT_PROFILE_SPEED_PERCENT) / 100;
    return (int32_t)speed;
}

/* The rows themselves: in order, no faster than their axes, at rest at both ends of the list. */
static solution_t judge_row(const robot_t *robot, const trajectory_row_t *row, bool is_end)
{
    solution_t result = {.status = STATUS_OK};
    for (uint32_t i = 0U; (i < robot->axis_count) && (result.status == STATUS_OK); i++) {
        const int32_t most = is_end ? 0 : highest_speed(&robot->axes[i]);
        const int32_t speed = row->speeds_ticks_per_s[i];
        if ((speed > most) || (speed < -most)) {
            result.status = STATUS_TRAJECTORY_SPEED;
            result.axis = (uint8_t)i;
            result.is_maximum = (speed > most) ? 1U : 0U;
        }
    }
    return result;
}

static bool follows(const trajectory_row_t *before, const trajectory_row_t *row)
{
    return (row->time_ms > before->time_ms) &&
           ((row->time_ms - before->time_ms) >= LIMIT_TRAJECTORY_STEP_LEAST_MS) &&
           ((row->time_ms - before->time_ms) <= LIMIT_TRAJECTORY_STEP_MOST_MS);
}

bool trajectory_list_is_in_zone(const axis_config_t *config, int32_t ticks)
{
    return (ticks < config->target_minimum_ticks) || (ticks > config->target_maximum_ticks);
}

/* An axis may stand and come from where homing has left it, but it is not driven there. */
static status_t judge_point(const axis_config_t *config, int32_t from, int32_t ticks)
{
    const int32_t slack = config->home_way_ticks;
    const bool is_outwards = ((ticks < config->target_minimum_ticks) && (ticks < from)) ||
                             ((ticks > config->target_maximum_ticks) && (ticks > from));
    const bool is_beyond = (ticks < config->minimum_ticks) || (ticks > config->maximum_ticks);
    const bool is_far =
        (ticks < (config->minimum_ticks - slack)) || (ticks > (config->maximum_ticks + slack));
    status_t status = STATUS_OK;
    if (is_far || (is_beyond && is_outwards)) {
        status = STATUS_AXIS_LIMIT;
    } else if (is_outwards) {
        status = STATUS_SWITCH_ZONE;
    } else {
        status = STATUS_OK;
    }
    return status;
}

/* One axis; its way is between its control points, which are left in `hull`. */
static solution_t judge_axis(const axis_config_t *config, const cubic_t *way, uint32_t axis,
                             hull_t *hull)
{
    const int32_t from = cubic_point_ticks(way, 0U);
    const int32_t to = cubic_point_ticks(way, CUBIC_POINTS - 1U);
    solution_t result = {.status = STATUS_OK, .axis = (uint8_t)axis};
    for (uint32_t i = 0U; (i < CUBIC_POINTS) && (result.status == STATUS_OK); i++) {
        const int32_t ticks = cubic_point_ticks(way, i);
        hull->ticks[i][axis] = ticks;
        result.status = judge_point(config, from, ticks);
        result.is_maximum = (ticks > config->target_maximum_ticks) ? 1U : 0U;
    }
    if (result.status != STATUS_OK) {
        /* The status says it already. */
    } else if ((to != from) && trajectory_list_is_in_zone(config, to)) {
        result.status = STATUS_SWITCH_ZONE;
    } else if (!cubic_keeps_speed(way, highest_speed(config)) ||
               !cubic_keeps_acceleration(way, config->acceleration_ticks_per_s2)) {
        result.status = STATUS_TRAJECTORY_SPEED;
    } else {
        result.status = STATUS_OK;
    }
    return result;
}

/* A limit that is not curved is kept between points that keep it. */
static solution_t judge_shared(const robot_t *robot, const hull_t *hull)
{
    solution_t result = {.status = STATUS_OK};
    for (uint32_t i = 0U; (i < CUBIC_POINTS) && (result.status == STATUS_OK); i++) {
        joints_t joints;
        joints_from_ticks(robot, hull->ticks[i], &joints);
        result = coupled_limit_judge(robot, &joints);
    }
    if (result.status == STATUS_OK) {
        result = coupled_path_judge(robot, hull->ticks[0], hull->ticks[CUBIC_POINTS - 1U]);
    }
    return result;
}

static bool stays(const hull_t *hull, uint32_t axis)
{
    bool is_still = true;
    for (uint32_t i = 1U; i < CUBIC_POINTS; i++) {
        is_still = is_still && (hull->ticks[i][axis] == hull->ticks[0][axis]);
    }
    return is_still;
}

static bool is_needle_out(const robot_t *robot, const hull_t *hull)
{
    bool is_out = true;
    for (uint32_t i = 0U; i < CUBIC_POINTS; i++) {
        is_out = is_out && (hull->ticks[i][robot->needle_axis] <= needle_out_ticks(robot));
    }
    return is_out;
}

/* Tissue is not cut sideways. */
static solution_t judge_needle(const robot_t *robot, const hull_t *hull)
{
    solution_t result = {.status = STATUS_OK};
    const bool is_out = is_needle_out(robot, hull);
    for (uint32_t i = 0U; (i < robot->axis_count) && !is_out && (result.status == STATUS_OK); i++) {
        const bool is_across = robot->axes[i].needle_motion == (uint32_t)NEEDLE_ACROSS;
        if (is_across && !stays(hull, i)) {
            result.status = STATUS_NEEDLE_IN;
            result.axis = (uint8_t)i;
        }
    }
    return result;
}

static solution_t judge_way(const robot_t *robot, const trajectory_row_t *from,
                            const trajectory_row_t *to)
{
    solution_t result = {.status = STATUS_OK};
    hull_t hull;
    (void)memset(&hull, 0, sizeof hull);
    for (uint32_t i = 0U; (i < robot->axis_count) && (result.status == STATUS_OK); i++) {
        cubic_t way;
        trajectory_list_way(from, to, i, &way);
        result = judge_axis(&robot->axes[i], &way, i, &hull);
    }
    if (result.status == STATUS_OK) {
        result = judge_shared(robot, &hull);
    }
    return (result.status == STATUS_OK) ? judge_needle(robot, &hull) : result;
}

static solution_t judge(const trajectory_list_t *self, const trajectory_row_t *rows,
                        const robot_t *robot, const trajectory_row_t *row)
{
    const bool is_first = self->count == 0U;
    const trajectory_row_t *const before = (self->count == 0U) ? row : &rows[self->count - 1U];
    solution_t result = {.status = STATUS_OK};
    if (row->time_ms > LIMIT_TRAJECTORY_TIME_MS) {
        result.status = STATUS_TRAJECTORY_ORDER;
    } else if (is_first) {
        /* There is nothing before it. */
    } else if (!trajectory_row_is_whole(before)) {
        result.status = STATUS_MEMORY_DAMAGED;
    } else {
        result.status = follows(before, row) ? STATUS_OK : STATUS_TRAJECTORY_ORDER;
    }
    if (result.status == STATUS_OK) {
        result = judge_row(robot, row, is_first || ((self->count + 1U) == self->total));
    }
    return (result.status == STATUS_OK) ? judge_way(robot, before, row) : result;
}

solution_t trajectory_list_add(trajectory_list_t *self,
                               trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS], const robot_t *robot,
                               uint32_t index, const trajectory_row_t *row)
{
    solution_t result = {.status = STATUS_TRAJECTORY_ORDER};
    const bool is_next = (index == self->count) && (index < self->total) &&
                         (index < LIMIT_TRAJECTORY_ROWS) && (self->is_whole == 0U);
    if (is_next) {
        result = judge(self, rows, robot, row);
    }
    if (result.status == STATUS_OK) {
        rows[index] = *row;
        rows[index].crc = trajectory_row_crc(row);
        self->crc = trajectory_list_crc(self->crc, row);
        self->count++;
    } else {
        trajectory_list_clear(self);
    }
    return result;
}

status_t trajectory_list_end(trajectory_list_t *self, uint32_t crc)
{
    status_t status = STATUS_OK;
    if ((self->total == 0U) || (self->count != self->total)) {
        status = STATUS_TRAJECTORY_ORDER;
    } else if (self->crc != crc) {
        status = STATUS_TRAJECTORY_SUM;
    } else {
        self->is_whole = 1U;
    }
    if (status != STATUS_OK) {
        trajectory_list_clear(self);
    }
    return status;
}

uint32_t trajectory_list_end_ms(const trajectory_list_t *self, const trajectory_row_t *rows)
{
    return (self->count > 0U) ? rows[self->count - 1U].time_ms : 0U;
}
