/* SPDX-License-Identifier: Apache-2.0 */
/** @file The cards that a robot names, by slot. */
#ifndef BORESIGHT_ROBOT_CARDS_H
#define BORESIGHT_ROBOT_CARDS_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Slots of the cards. */
typedef struct {
    uint32_t slots[ROBOT_AXIS_MAX]; /**< Slots of the axes' cards. */
    uint32_t sensor_slots;          /**< Bit n: a card without an axis belongs into slot n. */
    uint32_t named_slots;           /**< Bit n: a card belongs into slot n. */
} robot_cards_t;

/** Finds them in the first `axis_count` rows of a table, at most ROBOT_AXIS_MAX;
 * robot_cards_bound() must follow if the table may be damaged. */
void robot_cards_find(robot_cards_t *self, const robot_t *robot, uint32_t axis_count);

/**
 * Makes of whatever stands there slots that the box has.
 *
 * @satisfies SWR-MEMORY-006
 */
void robot_cards_bound(robot_cards_t *self);

/**
 * @return the axis whose card is in `slot`; ROBOT_AXIS_MAX when none is
 *
 * @satisfies SWR-ROBOT-013
 */
uint32_t robot_cards_axis(const robot_t *robot, uint32_t slot);

/** A card without an axis belongs into `slot`, below CARD_SLOT_COUNT. */
bool robot_cards_has_sensor(const robot_t *robot, uint32_t slot);

/** @return the card_type_t that the robot wants in `slot`; CARD_TYPE_NONE when it names none */
uint32_t robot_cards_type(const robot_t *robot, uint32_t slot);

#endif
