/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A pedal, button or handle that is held from afar, such as by a page of the console, opens by
 * itself unless its holder renews that again and again. It is counted in the world's time, which is
 * the holder's: the box's may pass slowly, or stand.
 */
#ifndef BORESIGHT_BOX_GRIP_H
#define BORESIGHT_BOX_GRIP_H

#include "sim/box.h"

#include <stdbool.h>
#include <stdint.h>

/** All zero at first. */
typedef struct {
    uint32_t renewals[BOX_HOLDS]; /**< Those of the box, when it was looked at last. */
    uint64_t until_us[BOX_HOLDS]; /**< Time at which it opens. */
} box_grip_t;

/**
 * True: something was opened. Opens what was held, and not renewed for LIMIT_BOX_GRIP_US; to be
 * called whenever the box looks around. `now_us` is of the world's clock.
 *
 * @satisfies SWR-BOX-020
 */
bool box_grip_look(box_grip_t *self, box_t *box, uint64_t now_us);

#endif
