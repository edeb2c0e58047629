/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/robot_cards.h"

uint32_t robot_cards_axis(const robot_t *robot, uint32_t slot)
{
    uint32_t found = ROBOT_AXIS_MAX;
    for (uint32_t i = 0U; (i < robot->axis_count) && (i < ROBOT_AXIS_MAX); i++) {
        found = (robot->axes[i].slot == slot) ? i : found;
    }
    return found;
}

uint32_t robot_cards_type(const robot_t *robot, uint32_t slot)
{
    const uint32_t axis = robot_cards_axis(robot, slot);
    return (axis < ROBOT_AXIS_MAX) ? (uint32_t)robot->axes[axis].card_type
                                   : (uint32_t)CARD_TYPE_NONE;
}
