/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/velocity/velocity_share.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

static int64_t magnitude(int64_t value)
{
    return (value < 0) ? -value : value;
}

/* The axis of a way: it is for one alone. */
static uint32_t only_axis(const velocity_mode_t *mode)
{
    uint32_t index = 0U;
    while ((index < (ROBOT_AXIS_MAX - 1U)) && ((mode->axes & LEG_AXIS(index)) == 0U)) {
        index++;
    }
    return index;
}

/* Duration of a way at the speed of that axis; the longest time ends it as well. */
static uint32_t way_ms(const velocity_mode_t *mode, int64_t way_ticks)
{
    const int64_t speed = magnitude((int64_t)mode->speeds_ticks_per_s[only_axis(mode)]);
    return (uint32_t)fixed_within((way_ticks * 1000) / speed, 0, (int64_t)LIMIT_VELOCITY_TIME_MS);
}

uint32_t velocity_share_span_ms(const velocity_mode_t *mode)
{
    return (mode->way_ticks > 0U) ? way_ms(mode, (int64_t)mode->way_ticks) : mode->time_ms;
}

/* While it runs. */
static uint32_t running_ms(const velocity_mode_t *mode, const axis_t axes[ROBOT_AXIS_MAX])
{
    const uint32_t index = only_axis(mode);
    uint32_t left_ms = (mode->left_cycles * LIMIT_CYCLE_US) / 1000U;
    if (mode->way_ticks > 0U) {
        const int64_t gone = magnitude((int64_t)axes[index].sealed.setpoint_ticks -
                                       (int64_t)mode->start_ticks[index]);
        left_ms = way_ms(mode, (int64_t)mode->way_ticks - gone);
    }
    return left_ms;
}

uint32_t velocity_share_left_ms(const velocity_mode_t *mode, const axis_t axes[ROBOT_AXIS_MAX])
{
    return velocity_mode_runs(mode) ? running_ms(mode, axes) : 0U;
}
