/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/robot_cards.h"

void robot_cards_find(robot_cards_t *self, const robot_t *robot, uint32_t axis_count)
{
    self->sensor_slots = robot->sensor_slots;
    self->named_slots = robot->sensor_slots;
    for (uint32_t i = 0U; i < axis_count; i++) {
        const uint32_t slot = (uint32_t)robot->axes[i].slot;
        self->slots[i] = slot;
        self->named_slots |= (uint32_t)1U << (slot % 32U); /* A row may be damaged by now. */
    }
}

void robot_cards_bound(robot_cards_t *self)
{
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        self->slots[i] = (self->slots[i] < CARD_SLOT_COUNT) ? self->slots[i] : 0U;
    }
    self->sensor_slots &= CARD_EVERY_SLOT;
    self->named_slots &= CARD_EVERY_SLOT;
}

uint32_t robot_cards_axis(const robot_t *robot, uint32_t slot)
{
    uint32_t found = ROBOT_AXIS_MAX;
    for (uint32_t i = 0U; (i < robot->axis_count) && (i < ROBOT_AXIS_MAX); i++) {
        found = (robot->axes[i].slot == slot) ? i : found;
    }
    return found;
}

bool robot_cards_has_sensor(const robot_t *robot, uint32_t slot)
{
    return ((robot->sensor_slots >> slot) & 1U) != 0U;
}

uint32_t robot_cards_type(const robot_t *robot, uint32_t slot)
{
    const uint32_t axis = robot_cards_axis(robot, slot);
    if (axis < ROBOT_AXIS_MAX) {
        return (uint32_t)robot->axes[axis].card_type;
    }
    return robot_cards_has_sensor(robot, slot) ? (uint32_t)CARD_TYPE_SENSOR
                                               : (uint32_t)CARD_TYPE_NONE;
}
