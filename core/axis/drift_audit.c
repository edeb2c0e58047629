/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/drift_audit.h"

#include "limits/requirement_limits.h"
#include "robot/joints.h"

void drift_audit_settle(drift_audit_t *self)
{
    self->idle_ticks = 0;
    self->confirmed_ticks = 0;
}

void drift_audit_confirm(drift_audit_t *self, const axis_config_t *config)
{
    if (drift_audit_is_far(self, config)) {
        drift_audit_settle(self);
    } else {
        self->confirmed_ticks = self->idle_ticks;
    }
}

void drift_audit_begin_scan(drift_audit_t *self)
{
    self->scan_ticks = 0;
}

bool drift_audit_is_beyond(const drift_audit_t *self, const axis_config_t *config)
{
    const int64_t way = fixed_magnitude((int64_t)self->idle_ticks - (int64_t)self->confirmed_ticks);
    return (way != 0) && joints_is_beyond(config, way, LIMIT_DRIFT_WAY_NM, LIMIT_DRIFT_WAY_BAM) &&
           joints_is_above(config, way, LIMIT_DRIFT_FLOOR_TICKS);
}

bool drift_audit_is_far(const drift_audit_t *self, const axis_config_t *config)
{
    return fixed_magnitude((int64_t)self->idle_ticks) > (int64_t)config->drift_ticks;
}
