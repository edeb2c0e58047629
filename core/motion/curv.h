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
 * @param alpha_q16 0..65536
 * @param away_bam  theta - theta_d, wraps
 * @return w / w_most, 0..65536, within 20 / 65536
 *
 * @satisfies SWR-STEER-001
 */
uint32_t curv_share_q16(uint32_t alpha_q16, int32_t away_bam);

/**
 * The speed of the law where the rotation's axis stands at `ticks`, at its whole speed.
 *
 * @return ticks/s, 8 fraction bits, 0 or more
 *
 * @satisfies SWR-STEER-001
 */
int64_t curv_speed_q8(const axis_config_t *config, const steering_t *steering, int32_t ticks);

#endif
