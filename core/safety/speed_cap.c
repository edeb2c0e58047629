/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/speed_cap.h"

#include "limits/requirement_limits.h"

#define TICK (INT64_C(100) * 1000000)

bool speed_cap_step(speed_cap_t *self, const axis_config_t *config, uint32_t percent,
                    int32_t position_ticks, uint32_t elapsed_us)
{
    /* A speed is a million at most, and so are both in 32 bits. */
    const int32_t share = (int32_t)percent + (int32_t)LIMIT_SPEED_CAP_TOLERANCE_PERCENT;
    const int32_t rate = config->speed_ticks_per_s * share;
    const int64_t most = (int64_t)rate * (int32_t)LIMIT_SPEED_CAP_US;
    const int64_t way = (int64_t)position_ticks - (int64_t)self->position_ticks;
    if ((way == 0) && (self->left == most)) {
        return false; /* It rests, and no more is kept. */
    }
    self->position_ticks = position_ticks;
    self->left += ((int64_t)rate * (int64_t)elapsed_us) - (TICK * ((way < 0) ? -way : way));
    if (self->left > most) {
        self->left = most;
    }
    const bool is_used_up = self->left < 0;
    if (is_used_up) {
        self->left = 0;
    }
    return is_used_up;
}
