/* SPDX-License-Identifier: Apache-2.0 */
/** @file The cards that a robot names, by slot. */
#ifndef BORESIGHT_ROBOT_CARDS_H
#define BORESIGHT_ROBOT_CARDS_H

#include "robot/robot.h"

#include <stdint.h>

/**
 * @return the axis whose card is in `slot`; ROBOT_AXIS_MAX when none is
 *
 * @satisfies SWR-ROBOT-013
 */
uint32_t robot_cards_axis(const robot_t *robot, uint32_t slot);

/** @return the card_type_t that the robot wants in `slot`; CARD_TYPE_NONE when it names none */
uint32_t robot_cards_type(const robot_t *robot, uint32_t slot);

#endif
