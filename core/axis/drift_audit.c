/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/drift_audit.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "motion/motor_model.h"
#include "robot/joints.h"

static int32_t sum(int32_t account_ticks, int64_t way_ticks)
{
    return fixed_saturate((int64_t)account_ticks + way_ticks);
}

void drift_audit_step(drift_audit_t *self, int32_t position_ticks, bool is_off, uint32_t elapsed_us)
{
    const int64_t way = (int64_t)position_ticks - (int64_t)self->position_ticks;
    self->position_ticks = position_ticks;
    if (!is_off) {
        self->off_us = 0U;
    } else if (self->off_us < MOTOR_REST_US) {
        self->off_us += elapsed_us;
    } else if (way != 0) {
        self->idle_ticks = sum(self->idle_ticks, way);
        self->scan_ticks = sum(self->scan_ticks, way);
    } else {
        /* It stands. */
    }
}

void drift_audit_settle(drift_audit_t *self, int32_t position_ticks)
{
    self->position_ticks = position_ticks;
    self->idle_ticks = 0;
}

void drift_audit_begin_scan(drift_audit_t *self)
{
    self->scan_ticks = 0;
}

bool drift_audit_is_beyond(const drift_audit_t *self, const axis_config_t *config)
{
    const int64_t way = fixed_magnitude((int64_t)self->idle_ticks);
    return (way != 0) && joints_is_beyond(config, way, LIMIT_DRIFT_WAY_NM, LIMIT_DRIFT_WAY_BAM) &&
           joints_is_above(config, way, LIMIT_DRIFT_FLOOR_TICKS);
}

bool drift_audit_is_far(const drift_audit_t *self, const axis_config_t *config)
{
    return fixed_magnitude((int64_t)self->idle_ticks) > (int64_t)config->drift_ticks;
}
