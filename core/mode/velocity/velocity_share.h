/* SPDX-License-Identifier: Apache-2.0 */
/** @file How far commanded speeds have come, for who looks on. */
#ifndef BORESIGHT_VELOCITY_SHARE_H
#define BORESIGHT_VELOCITY_SHARE_H

#include "mode/velocity/velocity_mode.h"

#include <stdint.h>

/** Duration of the request, ms, 0..LIMIT_VELOCITY_TIME_MS: its time, or its way at its speed. */
uint32_t velocity_share_span_ms(const velocity_mode_t *mode);

/** Rest of that, ms; for a way, the part that the set-point has not gone; 0 before it has begun,
 * and once all set-points have come to rest. */
uint32_t velocity_share_left_ms(const velocity_mode_t *mode, const axis_t axes[ROBOT_AXIS_MAX]);

#endif
