/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The account of vain homing: the way that each axis was moved by START_UPs that an axis or a card
 * has ended. It begins anew when START_UP is done, or when it is spent and the operator restores,
 * sets or confirms a position.
 */
#ifndef BORESIGHT_HOMING_ACCOUNT_H
#define BORESIGHT_HOMING_ACCOUNT_H

#include "axis/axis.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Its values matter while controller_t's account_state is not EMPTY. */
typedef enum {
    HOMING_ACCOUNT_EMPTY,
    HOMING_ACCOUNT_OPEN,
    HOMING_ACCOUNT_SPENT, /**< START_UP homes nothing any more. */
} homing_account_state_t;

typedef struct {
    int32_t
        from_readings[ROBOT_AXIS_MAX];  /**< Readings of the encoders when the present try began. */
    int32_t ways_ticks[ROBOT_AXIS_MAX]; /**< Way that was moved, whatever the direction. */
    uint32_t homed;                     /**< Bit n: axis n was homed when the try began. */
    uint32_t seal; /**< Seal of the above: looked at only when they are used. */
} homing_account_t;

/** Nothing has been moved. */
void homing_account_init(homing_account_t *self);

/** A try begins with the axes as they are. */
void homing_account_begin(homing_account_t *self, const robot_t *robot,
                          const axis_t axes[ROBOT_AXIS_MAX]);

/** Only these functions have written it. */
bool homing_account_is_intact(const homing_account_t *self);

/** The try has failed: each axis is charged with its way, but one that was homed in it begins
 * anew. `failed`, ROBOT_AXIS_MAX if it was a card, has ended it, and its counts may have missed a
 * way: it is charged with its greatest following error at least. */
void homing_account_charge(homing_account_t *self, const robot_t *robot,
                           const axis_t axes[ROBOT_AXIS_MAX], uint32_t failed);

/** An axis was moved by more than LIMIT_VAIN_WAY_NM or LIMIT_VAIN_WAY_BAM, or the account is
 * damaged: the way is unknown. */
bool homing_account_is_beyond(const homing_account_t *self, const robot_t *robot);

#endif
