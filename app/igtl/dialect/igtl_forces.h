/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Forces of the robot's sensor, for peers of every dialect: SENSOR for who asks by GET_SENSOR, and
 * text for the answer to the COMMAND Status. A force that is doubtful, or that no sensor measures,
 * is never a number here, but the reason for that.
 */
#ifndef BORESIGHT_IGTL_FORCES_H
#define BORESIGHT_IGTL_FORCES_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/wire/igtl_outbox.h"
#include "robot/robot.h"

#include <stddef.h>

/**
 * Answers GET_SENSOR of `name`, of FORCE_HAND or FORCE_NEEDLE, and of both if it is empty: SENSOR
 * with the filtered force in newton, or STATUS with the reason.
 *
 * @satisfies SWR-IGTL-610
 * @satisfies SWR-IGTL-611
 */
void igtl_forces_report(igtl_outbox_t *outbox, const robot_t *robot, const char *name,
                        const igtl_moment_t *moment);

/**
 * Writes ` ForceHand="1.250" ForceNeedle="NOT_ZEROED" Sight="OFF"` of a robot with a force sensor:
 * newtons, or the first doubt, and whether a puncture can be found now; of another one nothing.
 * `snapshot` is not NULL.
 *
 * @return characters of `text`, of which it takes `size` at most
 *
 * @satisfies SWR-IGTL-612
 * @satisfies SWR-IGTL-757
 */
size_t igtl_forces_write(const robot_t *robot, const snapshot_t *snapshot, char *text, size_t size);

#endif
