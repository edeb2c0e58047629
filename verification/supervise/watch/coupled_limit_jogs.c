/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/coupled_limit_jogs.h"

#include "supervise/watch/truth.h"

#include <math.h>

#define FAR_PART 0.93  /* Part of the range that one carriage goes from the other... */
#define OUT_PART 0.45  /* ...and the second from its home. */
#define EDGE_PART 0.01 /* Part of the range: no jog is to end nearer to an end. */
#define EDGE_TRIES 24U

static uint32_t between(sim_random_t *random, uint32_t least, uint32_t most)
{
    return least + sim_random_below(random, most - least + 1U);
}

static uint32_t count_of(const coupled_limit_jogs_t *self)
{
    uint32_t count = 0U;
    for (uint32_t axes = truth_coupled_axes(self->robot, self->limit); axes != 0U; axes >>= 1) {
        count += axes & 1U;
    }
    return count;
}

/* The axis number `part` of its axes, in the order of the robot. */
static uint32_t axis_of(const coupled_limit_jogs_t *self, uint32_t part)
{
    const uint32_t axes = truth_coupled_axes(self->robot, self->limit);
    uint32_t left = part;
    uint32_t index = 0U;
    while ((((axes >> index) & 1U) == 0U) || (left > 0U)) {
        left -= (axes >> index) & 1U;
        index++;
    }
    return index;
}

void coupled_limit_jogs_begin(coupled_limit_jogs_t *self, const robot_t *robot,
                              sim_random_t *random)
{
    const uint32_t count = robot->coupled_limit_count;
    *self = (coupled_limit_jogs_t){.robot = robot,
                                   .limit = (count > 1U) ? sim_random_below(random, count) : 0U};
}

uint32_t coupled_limit_jogs_some_axis(const coupled_limit_jogs_t *self, sim_random_t *random)
{
    const uint32_t others = count_of(self) - 1U;
    uint32_t part = 0U;
    if (sim_random_below(random, 4U) == 0U) {
        part = (others > 1U) ? between(random, 1U, others) : others;
    }
    return axis_of(self, part);
}

/* Two that count alike, of which the second has no switch: they can go out one behind the other. */
static bool is_of_carriages(const coupled_limit_jogs_t *self)
{
    if (count_of(self) != 2U) {
        return false;
    }
    const axis_config_t *const first = &self->robot->axes[axis_of(self, 0U)];
    const axis_config_t *const second = &self->robot->axes[axis_of(self, 1U)];
    return (first->unit_per_tick_q16 == second->unit_per_tick_q16) &&
           (first->limit_switch != (uint8_t)LIMIT_SWITCH_NONE) &&
           (second->limit_switch == (uint8_t)LIMIT_SWITCH_NONE);
}

/* A part of the range in ticks of the first axis, in whole hundreds. */
static int32_t range_ticks(const coupled_limit_jogs_t *self, double part)
{
    const axis_config_t *const first = &self->robot->axes[axis_of(self, 0U)];
    const double range = truth_coupled_range(self->robot, self->limit);
    return 100 * (int32_t)lround(part * range / truth_measure(first, 100.0));
}

bool coupled_limit_jogs_is_out(const coupled_limit_jogs_t *self, const rig_t *rig)
{
    return !is_of_carriages(self) || (rig->box.axes[axis_of(self, 1U)].motor.position_ticks <=
                                      -(double)range_ticks(self, OUT_PART));
}

static command_t jog(uint32_t axis, int32_t ticks)
{
    return (command_t){.kind = (uint32_t)COMMAND_JOG, .as.jog = {.axis = axis, .to_ticks = ticks}};
}

static int32_t clamped(const axis_config_t *axis, int32_t ticks)
{
    const int32_t least = axis->target_minimum_ticks;
    const int32_t most = axis->target_maximum_ticks;
    return (ticks < least) ? least : (ticks > most) ? most : ticks;
}

/* The first goes ahead, as far from the second as it may, then the second close behind. */
static command_t carriage_jog(const coupled_limit_jogs_t *self, const rig_t *rig,
                              sim_random_t *random)
{
    const uint32_t first = axis_of(self, 0U);
    const uint32_t second = axis_of(self, 1U);
    const int32_t ahead = rig->outputs.snapshot.axes[first].position_ticks;
    const int32_t behind = rig->outputs.snapshot.axes[second].position_ticks;
    const int32_t half = range_ticks(self, FAR_PART) / 2;
    const int32_t way = (int32_t)between(random, 1U, (uint32_t)half);
    const bool is_first = ahead > (behind - half);
    const uint32_t index = is_first ? first : second;
    const int32_t ticks = is_first ? (behind - half - way) : (ahead + (way / 2));
    return jog(index, clamped(&self->robot->axes[index], ticks));
}

/* How far inside the coupled limits, as a part of their ranges; below 0: beyond one. */
static double least_room(const robot_t *robot, const double ticks[ROBOT_AXIS_MAX])
{
    double room = 1.0;
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        room = fmin(room, -truth_coupled_beyond(robot, i, ticks) / truth_coupled_range(robot, i));
    }
    return room;
}

static command_t some_jog(const coupled_limit_jogs_t *self, sim_random_t *random)
{
    const uint32_t index = axis_of(self, sim_random_below(random, count_of(self)));
    const axis_config_t *const axis = &self->robot->axes[index];
    const uint32_t span = (uint32_t)(axis->target_maximum_ticks - axis->target_minimum_ticks);
    return jog(index, axis->target_minimum_ticks + (int32_t)sim_random_below(random, span + 1U));
}

/* The one of some jogs that ends nearest to the end of a limit. */
static command_t edge_jog(const coupled_limit_jogs_t *self, const rig_t *rig, sim_random_t *random)
{
    double places[ROBOT_AXIS_MAX] = {0.0};
    double least = 1.0;
    command_t best = some_jog(self, random);
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        places[i] = rig->outputs.snapshot.axes[i].position_ticks;
    }
    for (uint32_t i = 0U; i < EDGE_TRIES; i++) {
        const command_t next = some_jog(self, random);
        const double here = places[next.as.jog.axis];
        places[next.as.jog.axis] = next.as.jog.to_ticks;
        const double room = least_room(self->robot, places);
        places[next.as.jog.axis] = here;
        if ((room > EDGE_PART) && (room < least)) {
            best = next;
            least = room;
        }
    }
    return best;
}

command_t coupled_limit_jogs_jog(const coupled_limit_jogs_t *self, const rig_t *rig,
                                 sim_random_t *random)
{
    return is_of_carriages(self) ? carriage_jog(self, rig, random) : edge_jog(self, rig, random);
}
