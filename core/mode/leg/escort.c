/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/leg/escort.h"

#include "axis/follower.h"
#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/kinematics.h"
#include "safety/coupled_guard.h"

#define PACE_MOST UINT32_C(2)
/* The bit of each axis that goes twice the way. */
#define DOUBLES 0xAAAAAAAAU
#define PACE_MASK UINT32_C(3)
/* In less time no axis goes the shorter of the two ways ahead. */
#define WAIT_CYCLES 16U
/* Change by rounding of a value that does not change, nm or bam. */
#define SAME INT64_C(64)

/* The way ahead with one escort. */
typedef struct {
    const robot_t *robot;
    const axis_t *axes;
    uint32_t leader;
    uint32_t paces;
    int64_t way_ticks; /* Way of the leader, towards its switch. */
    joints_t from;     /* Joints of the others, before it and after it. */
    joints_t to;
    int64_t far_ticks;  /* Bounds of the leader before it: farthest from its switch, */
    int64_t near_ticks; /* and nearest to it. */
} escort_outlook_t;

static uint32_t shift_of(uint32_t index)
{
    return 2U * index;
}

static uint32_t pace_of(uint32_t paces, uint32_t index)
{
    return (paces >> shift_of(index)) & PACE_MASK;
}

static bool is_upper(const axis_config_t *config)
{
    return config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
}

/* Both share a limit, and a tick is the same way of both. */
static bool can_come(const robot_t *robot, uint32_t leader, uint32_t index)
{
    bool is_shared = false;
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        is_shared =
            is_shared || (coupled_limit_has(limit, leader) && coupled_limit_has(limit, index));
    }
    return is_shared && (index != leader) &&
           (robot->axes[index].unit_per_tick_q16 == robot->axes[leader].unit_per_tick_q16);
}

/* The escort that is tried after `paces`, none of it faster than `most`; 0 after the last one. */
static uint32_t next_paces(const robot_t *robot, uint32_t leader, uint32_t paces, uint32_t most)
{
    uint32_t next = paces;
    bool is_next = false;
    for (uint32_t i = 0U; (i < robot->axis_count) && !is_next; i++) {
        const uint32_t pace = pace_of(next, i);
        const bool is_any = can_come(robot, leader, i);
        is_next = is_any && (pace < most);
        next &= is_any ? ~(PACE_MASK << shift_of(i)) : UINT32_MAX;
        next |= is_next ? ((pace + 1U) << shift_of(i)) : 0U;
    }
    return next;
}

static int64_t value_with(const escort_outlook_t *self, uint32_t limit_index,
                          const joints_t *others, int64_t leader_ticks)
{
    joints_t joints;
    joints = *others;
    joints.value[self->leader] =
        joints_of(&self->robot->axes[self->leader], fixed_saturate(leader_ticks));
    return kinematics_coupled(self->robot, limit_index, &joints);
}

/* Distance of `value` beyond `limit`. */
static int64_t excess_of(const coupled_limit_t *limit, int64_t value)
{
    int64_t excess = 0;
    if (value > (int64_t)limit->maximum) {
        excess = value - (int64_t)limit->maximum;
    } else if (value < (int64_t)limit->minimum) {
        excess = (int64_t)limit->minimum - value;
    } else {
        excess = 0;
    }
    return excess;
}

/* `part` of `whole` of the way `ticks`; all of it when it is more. */
static int64_t share_of(int64_t ticks, int64_t part, int64_t whole)
{
    int64_t share = ticks;
    if (part < whole) {
        const uint64_t product = (uint64_t)fixed_magnitude(ticks) * (uint64_t)part;
        const int64_t size = (int64_t)fixed_divide(product, (uint64_t)whole);
        share = (ticks < 0) ? -size : size;
    }
    return share;
}

static bool is_distance(const escort_outlook_t *self, const coupled_limit_t *limit)
{
    uint32_t others = limit->axes & ~((uint32_t)1U << self->leader);
    others &= others - 1U;
    return coupled_limit_has(limit, self->leader) && (limit->is_curved == 0U) && (others == 0U);
}

/* The value of a limit of two axes is a distance, and holds: the axis is where that lets it be. */
static void narrow(escort_outlook_t *self)
{
    for (uint32_t i = 0U; i < self->robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &self->robot->coupled_limits[i];
        if (is_distance(self, limit)) {
            const int64_t ticks = self->near_ticks - self->far_ticks;
            const int64_t far = value_with(self, i, &self->from, self->far_ticks);
            const int64_t near = value_with(self, i, &self->from, self->near_ticks);
            const int64_t span = fixed_magnitude(near - far);
            self->near_ticks -= share_of(ticks, excess_of(limit, near), span);
            self->far_ticks += share_of(ticks, excess_of(limit, far), span);
        }
    }
}

/* Possible places of the leader: somewhere in its travel, and as far from its other end as it has
 * come. With no place left, it is where it is nearest to its switch. */
static void find_places(escort_outlook_t *self)
{
    const axis_config_t *const config = &self->robot->axes[self->leader];
    const axis_t *const axis = &self->axes[self->leader];
    const int64_t end = (int64_t)(is_upper(config) ? config->minimum_ticks : config->maximum_ticks);
    self->far_ticks =
        end + (int64_t)axis->sealed.encoder.position_ticks - axis->sealed.homing.start_ticks;
    self->near_ticks = (int64_t)config->home_ticks - self->way_ticks;
    if (is_upper(config) ? (self->far_ticks > self->near_ticks)
                         : (self->far_ticks < self->near_ticks)) {
        self->far_ticks = self->near_ticks;
    }
}

static void look_ahead(escort_outlook_t *self)
{
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const axis_config_t *const config = &self->robot->axes[i];
        const int64_t ticks = (int64_t)self->axes[i].sealed.encoder.position_ticks;
        const int64_t way = self->way_ticks * (int64_t)pace_of(self->paces, i);
        self->from.value[i] = joints_of(config, fixed_saturate(ticks));
        self->to.value[i] = joints_of(config, fixed_saturate(ticks + way));
    }
    find_places(self);
    narrow(self);
}

/* No soft limit stands in the way of the escort. */
static bool has_room(const escort_outlook_t *self)
{
    bool has_all = true;
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const axis_config_t *const config = &self->robot->axes[i];
        const int64_t pace = (int64_t)pace_of(self->paces, i);
        const int64_t end =
            (int64_t)self->axes[i].sealed.encoder.position_ticks + (pace * self->way_ticks);
        const bool is_within =
            (end >= (int64_t)config->minimum_ticks) && (end <= (int64_t)config->maximum_ticks);
        has_all = has_all && ((pace == 0) || is_within);
    }
    return has_all;
}

/* The value goes from `from` to `to`, and what it is at most or least afterwards is not inside. */
static bool is_left(const coupled_limit_t *limit, int64_t from, int64_t to, int64_t worst)
{
    const coupled_side_t side = coupled_limit_side(limit, worst);
    return ((side == COUPLED_LIMIT_ABOVE) && ((to - from) > SAME)) ||
           ((side == COUPLED_LIMIT_BELOW) && ((from - to) > SAME));
}

/* Wherever the leader is, the value is between those with it at both of its places; if it grows
 * with one of them only, with the other as well for all that is known. */
static bool holds(const escort_outlook_t *self, uint32_t limit_index)
{
    const coupled_limit_t *const limit = &self->robot->coupled_limits[limit_index];
    const int64_t places[2] = {self->far_ticks, self->near_ticks};
    int64_t from[2];
    int64_t to[2];
    bool is_kept = true;
    for (uint32_t i = 0U; i < 2U; i++) {
        from[i] = value_with(self, limit_index, &self->from, places[i]);
        to[i] = value_with(self, limit_index, &self->to, places[i] + self->way_ticks);
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        is_kept = is_kept && !is_left(limit, from[i], to[i], to[0]) &&
                  !is_left(limit, from[i], to[i], to[1]);
    }
    return is_kept;
}

static int64_t ticks_towards_switch(const axis_config_t *config, bool is_far)
{
    const int64_t ticks =
        is_far ? joints_ticks_within(config, LIMIT_ESCORT_FAR_NM, LIMIT_ESCORT_FAR_BAM)
               : joints_ticks_within(config, LIMIT_ESCORT_NEAR_NM, LIMIT_ESCORT_NEAR_BAM);
    return is_upper(config) ? ticks : -ticks;
}

static escort_outlook_t outlook_of(const escort_t *self, const robot_t *robot,
                                   const axis_t axes[ROBOT_AXIS_MAX], bool is_far)
{
    const uint32_t leader = self->leader - 1U;
    escort_outlook_t outlook = {.robot = robot,
                                .axes = axes,
                                .leader = leader,
                                .paces = self->paces,
                                .way_ticks = ticks_towards_switch(&robot->axes[leader], is_far)};
    look_ahead(&outlook);
    return outlook;
}

static bool is_good(const escort_t *self, const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                    bool is_far)
{
    const escort_outlook_t outlook = outlook_of(self, robot, axes, is_far);
    bool is_every_one = has_room(&outlook);
    for (uint32_t i = 0U; is_every_one && (i < robot->coupled_limit_count); i++) {
        is_every_one = holds(&outlook, i);
    }
    return is_every_one;
}

/* The escort keeps step from where it is. */
static void tie(const escort_t *self, const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX])
{
    axis_t *const leader = &axes[self->leader - 1U];
    const int64_t gone =
        (int64_t)leader->sealed.encoder.position_ticks - leader->sealed.homing.start_ticks;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const int64_t pace = (int64_t)escort_pace(self, i);
        if (pace > 0) {
            axes[i].sealed.homing.start_ticks =
                fixed_saturate((int64_t)axes[i].sealed.encoder.position_ticks - (pace * gone));
        }
    }
    homing_renew(&leader->sealed.homing);
}

bool escort_is_for(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    return (robot->axes[index].home_method == (uint8_t)HOME_BY_SWITCH) &&
           follower_is_in_block(robot, index) && coupled_guard_is_last(robot, axes, index);
}

void escort_begin(escort_t *self, const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    *self = (escort_t){.leader = index + 1U, .search = (uint32_t)ESCORT_SEARCH_EVEN};
    if (axes[index].chart.reference == AXIS_REFERENCE_LEAVE) {
        self->search = (uint32_t)ESCORT_SEARCH_DONE;
        for (uint32_t i = 0U; i < robot->axis_count; i++) {
            self->paces |= can_come(robot, index, i) ? ((uint32_t)1U << shift_of(i)) : 0U;
        }
        tie(self, robot, axes);
    }
}

void escort_end(escort_t *self)
{
    *self = (escort_t){.leader = 0U};
}

uint32_t escort_pace(const escort_t *self, uint32_t index)
{
    return pace_of(self->paces, index);
}

bool escort_was_missing(const escort_t *self, uint32_t index)
{
    return (self->leader == (index + 1U)) && (self->search == (uint32_t)ESCORT_SEARCH_IN_VAIN);
}

bool escort_is_slow(const escort_t *self)
{
    return (self->paces & DOUBLES) != 0U;
}

/* Tries one. */
static escort_verdict_t look_for(escort_t *self, const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX])
{
    const uint32_t most = (self->search == (uint32_t)ESCORT_SEARCH_EVEN) ? UINT32_C(1) : PACE_MOST;
    const bool is_near = self->search == (uint32_t)ESCORT_SEARCH_NEAR;
    escort_verdict_t verdict = ESCORT_RESTS;
    if (is_good(self, robot, axes, !is_near)) {
        self->search = (uint32_t)ESCORT_SEARCH_DONE;
        self->wait_cycles = WAIT_CYCLES;
        tie(self, robot, axes);
    } else {
        self->paces = next_paces(robot, self->leader - 1U, self->paces, most);
        if (self->paces == 0U) {
            verdict = is_near ? ESCORT_NONE : ESCORT_RESTS;
            self->search++;
        }
    }
    return verdict;
}

/* It goes on; now and then the way ahead is looked at. */
static escort_verdict_t keep(escort_t *self, const robot_t *robot,
                             const axis_t axes[ROBOT_AXIS_MAX])
{
    escort_verdict_t verdict = ESCORT_GOES;
    if (self->wait_cycles > 0U) {
        self->wait_cycles--;
    } else if (is_good(self, robot, axes, false)) {
        self->wait_cycles = WAIT_CYCLES;
    } else {
        self->paces = 0U;
        self->search = (uint32_t)ESCORT_SEARCH_EVEN;
        verdict = ESCORT_RESTS;
    }
    return verdict;
}

escort_verdict_t escort_step(escort_t *self, const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX])
{
    escort_verdict_t verdict = ESCORT_GOES;
    if (axes[self->leader - 1U].chart.reference != AXIS_REFERENCE_APPROACH) {
        verdict = ESCORT_GOES;
    } else if (self->search == (uint32_t)ESCORT_SEARCH_DONE) {
        verdict = keep(self, robot, axes);
    } else {
        verdict = look_for(self, robot, axes);
    }
    return verdict;
}

int32_t escort_way_by_hand_ticks(const escort_t *self, const robot_t *robot,
                                 const axis_t axes[ROBOT_AXIS_MAX])
{
    const escort_outlook_t outlook = outlook_of(self, robot, axes, false);
    const int64_t middle = ((outlook.far_ticks + outlook.near_ticks) / 2) -
                           (int64_t)axes[outlook.leader].sealed.encoder.position_ticks;
    return fixed_saturate(middle);
}
