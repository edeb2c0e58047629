/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/steering.h"

#include "base/fixed.h"

#include <string.h>

#define TURN_DEG INT64_C(360)
#define TURN_BAM INT64_C(4294967296)

/* Strength for a curvature. */
static uint32_t alpha_of(const steering_law_t *law, uint32_t curvature_per_km)
{
    uint32_t alpha_q16 = 0U;
    for (uint32_t i = 1U; (i < law->points) && (i < ROBOT_STEERING_POINTS); i++) {
        const uint32_t low = law->curvature_per_km[i - 1U];
        const uint32_t high = law->curvature_per_km[i];
        if (curvature_per_km >= low) {
            const uint32_t most = high - low;
            const uint32_t above = curvature_per_km - low;
            const uint32_t into = (above < most) ? above : most;
            const uint32_t rise = law->alpha_q16[i] - law->alpha_q16[i - 1U];
            alpha_q16 = law->alpha_q16[i - 1U] + ((rise * into) / most);
        }
    }
    return alpha_q16;
}

status_t steering_set(steering_t *self, const steering_law_t *law, uint32_t method,
                      uint32_t curvature_per_km, int32_t direction_deg)
{
    status_t status = STATUS_OK;
    (void)memset(self, 0, sizeof *self);
    if (law->points == 0U) {
        status = STATUS_NO_STEERING;
    } else if (method >= STEERING_METHOD_COUNT) {
        status = STATUS_UNKNOWN_COMMAND;
    } else if (curvature_per_km > law->most_per_km) {
        status = STATUS_STEERING_CURVATURE;
    } else if (method != (uint32_t)STEERING_NONE) {
        self->method = method;
        self->curvature_per_km = curvature_per_km;
        self->direction_deg = direction_deg;
        self->direction_bam =
            fixed_wrap_bam(fixed_divide_rounded((int64_t)direction_deg * TURN_BAM, TURN_DEG));
        self->alpha_q16 = alpha_of(law, curvature_per_km);
    } else {
        /* It is not steered. */
    }
    return status;
}
