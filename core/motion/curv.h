/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The rotation law CURV, by which a needle with a bevel tip is bent as much as is wanted while it
 * turns all the time: it turns slowly where the bevel bends it the wanted way, and fast elsewhere,
 *
 *     w(theta) = w_most (1 - alpha exp(-d^2 / (2 c^2))),   d = theta - theta_d in [-pi, pi)
 *
 * with the strength alpha from 0 (turns evenly, goes straight) to below 1. Law and width c:
 * Wartenberg et al., Annals of Biomedical Engineering 46 (2018). Its published code wraps d on one
 * side only; here both are. It holds on average over a turn, if the needle advances by a few mm in
 * one at most.
 */
#ifndef BORESIGHT_CURV_H
#define BORESIGHT_CURV_H

#include "robot/robot.h"
#include "robot/steering.h"

#include <stdint.h>

/**
 * The speed of the law where the rotation's axis stands at `ticks`; its most is
 * LIMIT_STEERING_SPEED_PERCENT of the highest speed of the axis, which has to catch up now and
 * then.
 *
 * @return ticks/s, 8 fraction bits, 0 or more; its share of that most is within 20 / 65536,
 * and that of a strength above 1 is taken for 1
 *
 * @satisfies SWR-STEER-001
 */
int64_t curv_speed_q8(const axis_config_t *config, const steering_t *steering, int32_t ticks);

#endif
