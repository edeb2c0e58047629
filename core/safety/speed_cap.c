/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/speed_cap.h"

#include "limits/requirement_limits.h"

#define TICK (INT64_C(100) * 1000000)

bool speed_cap_step(speed_cap_t *self, const axis_config_t *config, uint32_t percent,
                    int32_t position_ticks, uint32_t elapsed_us)
{
    const int64_t rate = (int64_t)config->speed_ticks_per_s *
                         ((int64_t)percent + (int64_t)LIMIT_SPEED_CAP_TOLERANCE_PERCENT);
    const int64_t most = rate * (int64_t)LIMIT_SPEED_CAP_US;
    const int64_t way = (int64_t)position_ticks - (int64_t)self->position_ticks;
    self->position_ticks = position_ticks;
    self->left += (rate * (int64_t)elapsed_us) - (TICK * ((way < 0) ? -way : way));
    if (self->left > most) {
        self->left = most;
    }
    const bool is_used_up = self->left < 0;
    if (is_used_up) {
        self->left = 0;
    }
    return is_used_up;
}
