/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The robot of a page as its server sees it: a closed loop that publishes by an exchange, as
 * boresight-control does. It is the module's clock, and its box is the one that the server orders.
 */
#ifndef BORESIGHT_SERVED_ROBOT_H
#define BORESIGHT_SERVED_ROBOT_H

#include "exchange/exchange.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

#define SERVED_ROBOT_BOX "page" /**< Name of its box. */

/** Begins anew. `utc_us` is the time of the world now. */
exchange_t *served_robot_start(const robot_t *robot, uint32_t seed, uint64_t utc_us);

/** Whether there is one. */
bool served_robot_is_started(void);

/** Gives an order to the box, whose reply is written to `size` bytes; false: refused. */
bool served_robot_order(const char *order, char *reply, uint32_t size);

/** The place of one more command of the next cycle, before those of the exchange; NULL: it takes no
 * more. */
command_t *served_robot_command(void);

/** Lets a cycle pass, with what was commanded by the exchange. */
void served_robot_step(void);

/** Since it was started. */
uint64_t served_robot_time_us(void);

#endif
