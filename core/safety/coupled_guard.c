/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/coupled_guard.h"

#include "axis/follower.h"
#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"
#include "robot/kinematics.h"

#include <string.h>

#define TICK_Q8_US INT64_C(256000000)
/* A count says where an axis is to within one. */
#define COUNT_TICKS INT64_C(1)

/* One limit in force, and how far it might be left. */
typedef struct {
    const robot_t *robot;
    const coupled_view_t *view;
    uint32_t index; /* Index of the limit. */
    joints_t at;    /* Joints of its axes; 0 for the others. */
    int64_t value;  /* There. */
    int64_t lowest;
    int64_t highest;
    joints_t low; /* The corners that the changes point at. */
    joints_t high;
    int64_t changes[ROBOT_AXIS_MAX]; /* By the way of each axis as it is requested. */
} reach_t;

static bool is_on(const card_drive_t *drive)
{
    return drive->mode != (uint32_t)CARD_DRIVE_OFF;
}

static uint32_t driven_axes(const robot_t *robot, const card_drive_t requests[ROBOT_AXIS_MAX])
{
    uint32_t driven = 0U;
    for (uint32_t i = robot->axis_count; i > 0U; i--) {
        driven = (driven << 1U) | (is_on(&requests[i - 1U]) ? 1U : 0U);
    }
    return driven;
}

static uint32_t unknown_axes(const robot_t *robot, const coupled_limit_t *limit,
                             const axis_t axes[ROBOT_AXIS_MAX])
{
    uint32_t unknown = 0U;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (coupled_limit_has(limit, i) && !axis_is_homed(&axes[i])) {
            unknown |= (uint32_t)1U << i;
        }
    }
    return unknown;
}

static void find_joints(const robot_t *robot, const coupled_limit_t *limit,
                        const axis_t axes[ROBOT_AXIS_MAX], joints_t *joints)
{
    (void)memset(joints, 0, sizeof *joints);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (coupled_limit_has(limit, i)) {
            joints->value[i] = joints_of(&robot->axes[i], axes[i].sealed.encoder.position_ticks);
        }
    }
}

static bool drives(const axis_config_t *config, const card_drive_t *drive, bool is_upwards)
{
    return is_on(drive) && (motor_model_is_upwards(config, drive) == is_upwards);
}

static int64_t full_speed_q8(const axis_config_t *config)
{
    return (int64_t)config->full_speed_ticks_per_s * 256;
}

/* Position of the axis at the end of its way. */
static int32_t end_of_way(const reach_t *self, uint32_t index, bool is_upwards)
{
    const axis_config_t *const config = &self->robot->axes[index];
    const encoder_t *const encoder = &self->view->axes[index].sealed.encoder;
    const int64_t measured_q8 = is_upwards ? (int64_t)encoder->speed_ticks_per_s_q8
                                           : -(int64_t)encoder->speed_ticks_per_s_q8;
    int64_t speed_q8 = 0;
    if (drives(config, &self->view->sent[index], is_upwards) ||
        drives(config, &self->view->requests[index], is_upwards)) {
        speed_q8 = full_speed_q8(config);
    }
    if (measured_q8 > speed_q8) {
        speed_q8 = measured_q8;
    }
    const int64_t ticks =
        COUNT_TICKS + (((speed_q8 * (int64_t)LIMIT_COUPLED_STOP_US) + TICK_Q8_US - 1) / TICK_Q8_US);
    return joints_of(
        config, fixed_saturate((int64_t)encoder->position_ticks + (is_upwards ? ticks : -ticks)));
}

static int64_t value_at(const reach_t *self, const joints_t *joints)
{
    return kinematics_coupled(self->robot, self->index, joints);
}

/* Looks at one end of the way of an axis. */
static int64_t widen(reach_t *self, uint32_t index, bool is_upwards)
{
    joints_t joints;
    joints = self->at;
    joints.value[index] = end_of_way(self, index, is_upwards);
    const int64_t change = value_at(self, &joints) - self->value;
    if (change > 0) {
        self->highest += change;
        self->high.value[index] = joints.value[index];
    } else {
        self->lowest += change;
        self->low.value[index] = joints.value[index];
    }
    return change;
}

static void find_reach(reach_t *self, const coupled_limit_t *limit)
{
    self->lowest = self->value;
    self->highest = self->value;
    self->low = self->at;
    self->high = self->at;
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        if (coupled_limit_has(limit, i)) {
            const int64_t up = widen(self, i, true);
            const int64_t down = widen(self, i, false);
            self->changes[i] =
                motor_model_is_upwards(&self->robot->axes[i], &self->view->requests[i]) ? up : down;
        }
    }
    if (limit->is_curved != 0U) {
        const int64_t lowest = value_at(self, &self->low);
        const int64_t highest = value_at(self, &self->high);
        self->lowest = (lowest < self->lowest) ? lowest : self->lowest;
        self->highest = (highest > self->highest) ? highest : self->highest;
    }
}

static bool is_any_fast(const reach_t *self, const coupled_limit_t *limit)
{
    bool is_any = false;
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const int64_t speed_q8 = (int64_t)self->view->axes[i].sealed.encoder.speed_ticks_per_s_q8;
        const int64_t full_q8 = full_speed_q8(&self->robot->axes[i]);
        is_any = is_any ||
                 (coupled_limit_has(limit, i) && ((speed_q8 > full_q8) || (speed_q8 < -full_q8)));
    }
    return is_any;
}

/* The requests among `driven` that take the limit away from its range. */
static uint32_t leaving_axes(reach_t *self, uint32_t driven)
{
    const coupled_limit_t *const limit = &self->robot->coupled_limits[self->index];
    uint32_t leaving = 0U;
    find_joints(self->robot, limit, self->view->axes, &self->at);
    self->value = value_at(self, &self->at);
    if ((coupled_limit_side(limit, self->value) == COUPLED_LIMIT_INSIDE) &&
        !is_any_fast(self, limit)) {
        return 0U;
    }
    find_reach(self, limit);
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const uint32_t mask = limit->axes & driven & ((uint32_t)1U << i);
        const bool is_above = (self->highest > (int64_t)limit->maximum) && (self->changes[i] > 0);
        const bool is_below = (self->lowest < (int64_t)limit->minimum) && (self->changes[i] < 0);
        leaving |= (is_above || is_below) ? mask : 0U;
    }
    return leaving;
}

/* Another axis of the limit goes the same way as axis `index`, which homes or is about to: the
 * whole block does then, and the distances between its axes stay. */
static bool is_in_block(const robot_t *robot, const coupled_limit_t *limit,
                        const axis_t axes[ROBOT_AXIS_MAX], uint32_t index, bool is_beginning)
{
    const uint32_t leader = follower_leader(robot, axes, index);
    bool is_in_one = false;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const bool comes_along = (is_beginning && follower_is_of(robot, i, index)) ||
                                 (follower_leader(robot, axes, i) == leader);
        is_in_one = is_in_one || ((i != index) && coupled_limit_has(limit, i) && comes_along);
    }
    return is_in_one;
}

/* Its way is planned by its counts, while another one of its linkage homes. */
static bool is_planned(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    bool is_any_homing = false;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        is_any_homing =
            is_any_homing || (axis_is_homing(&axes[i]) && follower_is_in_block(robot, i));
    }
    return is_any_homing && !axis_is_homing(&axes[index]) && axis_is_placed(&axes[index]) &&
           follower_is_in_block(robot, index);
}

/* Value of the limit with axis `index` at home. */
static int64_t value_at_home(const robot_t *robot, uint32_t limit_index,
                             const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    joints_t joints;
    find_joints(robot, &robot->coupled_limits[limit_index], axes, &joints);
    joints.value[index] = joints_of(&robot->axes[index], robot->axes[index].home_ticks);
    return kinematics_coupled(robot, limit_index, &joints);
}

/* The place of an axis that is not homed is unknown, but that of its switch is known. */
static bool is_home_beyond(const robot_t *robot, uint32_t limit_index,
                           const axis_t axes[ROBOT_AXIS_MAX], uint32_t index, bool is_beginning)
{
    const coupled_limit_t *const limit = &robot->coupled_limits[limit_index];
    const axis_config_t *const config = &robot->axes[index];
    if ((config->limit_switch == (uint8_t)LIMIT_SWITCH_NONE) ||
        (unknown_axes(robot, limit, axes) != ((uint32_t)1U << index)) ||
        is_in_block(robot, limit, axes, index, is_beginning) || is_planned(robot, axes, index)) {
        return false;
    }
    const int64_t value = value_at_home(robot, limit_index, axes, index);
    return (value < (int64_t)limit->minimum) || (value > (int64_t)limit->maximum);
}

bool coupled_guard_bars_homing(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index)
{
    bool is_barred = false;
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        is_barred = is_barred || (coupled_limit_has(&robot->coupled_limits[i], index) &&
                                  is_home_beyond(robot, i, axes, index, true));
    }
    return is_barred;
}

/* The requests among `driven` towards a switch that is beyond the limit. */
static uint32_t barred_axes(const robot_t *robot, const coupled_view_t *view, uint32_t limit_index,
                            uint32_t driven)
{
    uint32_t barred = 0U;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const config = &robot->axes[i];
        const uint32_t mask = driven & ((uint32_t)1U << i);
        const bool is_upper = config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
        if ((mask != 0U) && (motor_model_is_upwards(config, &view->requests[i]) == is_upper) &&
            is_home_beyond(robot, limit_index, view->axes, i, false)) {
            barred |= mask;
        }
    }
    return barred;
}

uint32_t coupled_guard_blocks(const robot_t *robot, const coupled_view_t *view)
{
    const uint32_t driven = driven_axes(robot, view->requests);
    uint32_t blocked = 0U;
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        if ((limit->axes & driven) == 0U) {
            /* No axis of it asks for a drive. */
        } else if (unknown_axes(robot, limit, view->axes) == 0U) {
            reach_t reach = {.robot = robot, .view = view, .index = i};
            blocked |= leaving_axes(&reach, driven);
        } else {
            blocked |= barred_axes(robot, view, i, limit->axes & driven);
        }
    }
    return blocked;
}

bool coupled_guard_is_missed(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                             uint32_t index)
{
    bool is_missed = false;
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        if (coupled_limit_has(limit, index) && (unknown_axes(robot, limit, axes) == 0U)) {
            joints_t joints;
            find_joints(robot, limit, axes, &joints);
            const int64_t value = kinematics_coupled(robot, i, &joints);
            const int64_t margin = coupled_limit_margin(limit);
            is_missed = is_missed || (value < ((int64_t)limit->minimum - margin)) ||
                        (value > ((int64_t)limit->maximum + margin));
        }
    }
    return is_missed;
}

bool coupled_guard_is_last(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    uint32_t sharing = 0U;
    bool is_every_placed = !axis_is_homed(&axes[index]);
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        sharing |= coupled_limit_has(limit, index) ? limit->axes : 0U;
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const bool is_sharing = ((sharing >> i) & 1U) != 0U;
        is_every_placed =
            is_every_placed && ((i == index) || !is_sharing || axis_is_placed(&axes[i]));
    }
    return is_every_placed && (sharing != 0U);
}

bool coupled_guard_is_known(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    bool is_every_known = axis_is_homed(&axes[index]);
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        is_every_known = is_every_known && (!coupled_limit_has(limit, index) ||
                                            (unknown_axes(robot, limit, axes) == 0U));
    }
    return is_every_known;
}

static int64_t value_of(const robot_t *robot, uint32_t limit_index,
                        const int32_t ticks[ROBOT_AXIS_MAX])
{
    const coupled_limit_t *const limit = &robot->coupled_limits[limit_index];
    joints_t joints = {.value = {0}};
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (coupled_limit_has(limit, i)) {
            joints.value[i] = joints_of(&robot->axes[i], ticks[i]);
        }
    }
    return kinematics_coupled(robot, limit_index, &joints);
}

bool coupled_guard_is_left(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                           uint32_t limit_index, const int32_t from_ticks[ROBOT_AXIS_MAX],
                           const int32_t to_ticks[ROBOT_AXIS_MAX])
{
    const coupled_limit_t *const limit = &robot->coupled_limits[limit_index];
    if (unknown_axes(robot, limit, axes) != 0U) {
        return false;
    }
    const int64_t from = value_of(robot, limit_index, from_ticks);
    const int64_t to = value_of(robot, limit_index, to_ticks);
    const coupled_side_t side = coupled_limit_side(limit, to);
    return ((side == COUPLED_LIMIT_ABOVE) && (to > from)) ||
           ((side == COUPLED_LIMIT_BELOW) && (to < from));
}

solution_t coupled_guard_judge(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index, int32_t ticks)
{
    solution_t result = {.status = STATUS_OK};
    for (uint32_t i = 0U; (i < robot->coupled_limit_count) && (result.status == STATUS_OK); i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        if (coupled_limit_has(limit, index) && (unknown_axes(robot, limit, axes) == 0U)) {
            joints_t joints;
            find_joints(robot, limit, axes, &joints);
            joints.value[index] = joints_of(&robot->axes[index], ticks);
            result = coupled_limit_refusal(limit, kinematics_coupled(robot, i, &joints));
        }
    }
    result.axis = (result.status == STATUS_OK) ? 0U : (uint8_t)index;
    return result;
}

solution_t coupled_guard_judge_homing(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                                      uint32_t index)
{
    solution_t result = {.status = STATUS_OK, .axis = (uint8_t)index, .is_maximum = 0U};
    for (uint32_t i = 0U; (i < robot->coupled_limit_count) && (result.status == STATUS_OK); i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        if (!coupled_limit_has(limit, index)) {
            /* It has no part in it. */
        } else if ((unknown_axes(robot, limit, axes) & ~((uint32_t)1U << index)) != 0U) {
            result.status = STATUS_NOT_HOMED;
        } else {
            const int64_t value = value_at_home(robot, i, axes, index);
            const bool is_below = value < (int64_t)limit->minimum;
            result.is_maximum = (value > (int64_t)limit->maximum) ? 1U : 0U;
            result.status =
                (is_below || (result.is_maximum != 0U)) ? (status_t)limit->refusal : STATUS_OK;
        }
    }
    return result;
}
