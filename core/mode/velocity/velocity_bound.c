/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/velocity/velocity_bound.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "safety/coupled_guard.h"

/* The nearer one. */
static void bind(velocity_bound_t *self, bool is_up, int64_t ticks, velocity_end_t end)
{
    if (is_up ? (ticks < (int64_t)self->ticks) : (ticks > (int64_t)self->ticks)) {
        self->ticks = fixed_saturate(ticks);
        self->end = end;
    }
}

static void bind_homed(velocity_bound_t *self, const axis_config_t *config, bool is_up)
{
    const int32_t soft_ticks = is_up ? config->maximum_ticks : config->minimum_ticks;
    const int32_t zone_ticks = is_up ? config->target_maximum_ticks : config->target_minimum_ticks;
    bind(self, is_up, (int64_t)soft_ticks, VELOCITY_END_SOFT_LIMIT);
    bind(self, is_up, (int64_t)zone_ticks, VELOCITY_END_SWITCH_ZONE);
}

bool velocity_bound_is_switch(const velocity_mode_t *self, const mode_frame_t *frame,
                              uint32_t index)
{
    const bool is_upper = frame->robot->axes[index].limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
    const bool is_up = self->speeds_ticks_per_s[index] > 0;
    return (frame->axes[index].sealed.limit_switches != 0U) && (is_upper == is_up);
}

velocity_bound_t velocity_bound_of(const velocity_mode_t *self, const mode_frame_t *frame,
                                   uint32_t index)
{
    const axis_config_t *const config = &frame->robot->axes[index];
    const axis_t *const axis = &frame->axes[index];
    const bool is_up = self->speeds_ticks_per_s[index] > 0;
    const int64_t start = (int64_t)self->start_ticks[index];
    velocity_bound_t bound = {is_up ? INT32_MAX : INT32_MIN, VELOCITY_END_TIME};
    if (axis_is_homed(axis)) {
        bind_homed(&bound, config, is_up);
    }
    if (!coupled_guard_is_known(frame->robot, frame->axes, index)) {
        const int64_t way =
            joints_ticks_within(config, LIMIT_UNHOMED_JOG_NM, LIMIT_UNHOMED_JOG_BAM);
        bind(&bound, is_up, start + (is_up ? way : -way), VELOCITY_END_SHORT_WAY);
    }
    if (self->way_ticks > 0U) {
        const int64_t way = (int64_t)self->way_ticks;
        bind(&bound, is_up, start + (is_up ? way : -way), VELOCITY_END_WAY);
    }
    if (velocity_bound_is_switch(self, frame, index)) {
        bind(&bound, is_up, (int64_t)axis->sealed.encoder.position_ticks, VELOCITY_END_SWITCH_ZONE);
    }
    return bound;
}

status_t velocity_bound_refusal(velocity_end_t end)
{
    status_t status = STATUS_OK;
    if (end == VELOCITY_END_SOFT_LIMIT) {
        status = STATUS_AXIS_LIMIT;
    } else if (end == VELOCITY_END_SWITCH_ZONE) {
        status = STATUS_SWITCH_ZONE;
    } else if (end == VELOCITY_END_SHORT_WAY) {
        status = STATUS_JOG_TOO_FAR;
    } else {
        /* All of its time or its way. */
    }
    return status;
}
