/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/homing_part.h"

#include "charts/axis_chart.h"

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

/* Nobody of a stage before its own is left to be homed. */
static bool is_due(const rig_t *rig, uint32_t axis)
{
    bool is_left = false;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        is_left = is_left || (!homing_part_is_homed(rig, i) &&
                              (config_of(rig, i)->home_stage < config_of(rig, axis)->home_stage));
    }
    return !is_left;
}

static bool is_following(const rig_t *rig, uint32_t axis)
{
    bool is_led = false;
    for (uint32_t stage = 1U; stage <= ROBOT_HOME_STAGES; stage++) {
        const uint32_t leader = config_of(rig, axis)->leaders[stage - 1U];
        is_led = is_led || ((leader != 0U) && homing_part_is_homing(rig, leader - 1U) &&
                            (config_of(rig, leader - 1U)->home_stage == stage));
    }
    return is_led;
}

bool homing_part_has(const rig_t *rig, uint32_t axis)
{
    const robot_t *const robot = rig->box.robot;
    const bool has_pose = (robot->pose_mask & ((uint32_t)1U << (uint32_t)POSE_HOME)) != 0U;
    return (rig->outputs.snapshot.is_homed != 0U)
               ? has_pose
               : ((homing_part_is_homing(rig, axis) && is_due(rig, axis)) ||
                  is_following(rig, axis) ||
                  ((axis == robot->needle_axis) && homing_part_is_homed(rig, axis)));
}
