/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/homing_part.h"

#include "charts/axis_chart.h"
#include "supervise/watch/truth.h"

static const axis_config_t *config_of(const rig_t *rig, uint32_t axis)
{
    return &rig->box.robot->axes[axis];
}

bool homing_part_is_homed(const rig_t *rig, uint32_t axis)
{
    const uint32_t grade = rig->outputs.snapshot.axes[axis].reference;
    return (grade == (uint32_t)AXIS_REFERENCE_TAKEN) ||
           (grade == (uint32_t)AXIS_REFERENCE_VERIFIED);
}

bool homing_part_is_homing(const rig_t *rig, uint32_t axis)
{
    const uint32_t leg = rig->outputs.snapshot.axes[axis].reference;
    return (leg == (uint32_t)AXIS_REFERENCE_LEAVE) || (leg == (uint32_t)AXIS_REFERENCE_APPROACH) ||
           (leg == (uint32_t)AXIS_REFERENCE_BACK_OFF) || (leg == (uint32_t)AXIS_REFERENCE_LATCH);
}

static bool share_a_limit(const robot_t *robot, uint32_t first, uint32_t second)
{
    const uint32_t both = ((uint32_t)1U << first) | ((uint32_t)1U << second);
    bool is_shared = false;
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        is_shared = is_shared || ((truth_coupled_axes(robot, i) & both) == both);
    }
    return is_shared;
}

static bool is_fresh(const rig_t *rig, uint32_t axis)
{
    return rig->outputs.snapshot.axes[axis].reference == (uint32_t)AXIS_REFERENCE_FRESH;
}

/* Carriages that were lost home one after the other in an order of their own, which their counts
 * decide; of two stages none do so at once. */
static bool is_before(const rig_t *rig, uint32_t axis, uint32_t other)
{
    const bool has_order = is_fresh(rig, other) || homing_part_is_homing(rig, other) ||
                           !share_a_limit(rig->box.robot, axis, other);
    return !homing_part_is_homed(rig, other) && has_order &&
           (config_of(rig, other)->home_stage < config_of(rig, axis)->home_stage);
}

/* No axis of a stage before its own is left to be homed. */
static bool is_due(const rig_t *rig, uint32_t axis)
{
    bool is_left = false;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        is_left = is_left || is_before(rig, axis, i);
    }
    return !is_left;
}

static bool is_following(const rig_t *rig, uint32_t axis)
{
    bool is_led = false;
    for (uint32_t scenario = 1U; scenario <= ROBOT_HOME_STAGES; scenario++) {
        const uint32_t leader = config_of(rig, axis)->leaders[scenario - 1U];
        is_led = is_led || ((leader != 0U) && homing_part_is_homing(rig, leader - 1U) &&
                            (config_of(rig, leader - 1U)->home_stage == scenario));
    }
    return is_led;
}

/* Goes along so that a limit that both share is kept; that it is, is another sentence. Where a
 * fresh one stands is not known. */
static bool is_escorting(const rig_t *rig, uint32_t axis)
{
    bool is_with_one = false;
    for (uint32_t i = 0U; !is_fresh(rig, axis) && (i < rig->box.robot->axis_count); i++) {
        is_with_one = is_with_one || ((i != axis) && homing_part_is_homing(rig, i) &&
                                      share_a_limit(rig->box.robot, axis, i));
    }
    return is_with_one;
}

static bool is_carriage(const robot_t *robot, uint32_t axis)
{
    bool is_one = false;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        is_one = is_one || ((i != axis) && share_a_limit(robot, axis, i));
    }
    return is_one;
}

uint32_t homing_part_lost_carriages(const rig_t *rig)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        const bool is_lost = !homing_part_is_homed(rig, i) && !is_fresh(rig, i);
        count += (is_lost && is_carriage(rig->box.robot, i)) ? 1U : 0U;
    }
    return count;
}

bool homing_part_has(const rig_t *rig, uint32_t axis)
{
    const robot_t *const robot = rig->box.robot;
    const bool has_pose = (robot->pose_mask & ((uint32_t)1U << (uint32_t)POSE_HOME)) != 0U;
    return (rig->outputs.snapshot.is_homed != 0U)
               ? has_pose
               : ((homing_part_is_homing(rig, axis) && is_due(rig, axis)) ||
                  is_following(rig, axis) || is_escorting(rig, axis) ||
                  ((axis == robot->needle_axis) && homing_part_is_homed(rig, axis)));
}
