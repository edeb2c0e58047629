/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/box_clock.h"

#include "limits/requirement_limits.h"

#include <stddef.h>

/* Counted in looks, of which a pause of the machine is one: it does not use the timeout up. */
#define PATIENT_LOOKS (LIMIT_ELASTIC_ANSWER_CLOCK_US / BOX_CLOCK_LOOK_US)

void box_clock_init(box_clock_t *self, box_time_t time, uint64_t now_us, uint64_t world_us)
{
    *self = (box_clock_t){.time = time,
                          .now_us = time.is_elastic ? now_us : (world_us / time.slowness),
                          .looked_us = world_us,
                          .lonely_looks = 0U};
}

static uint64_t elastic_now_us(box_clock_t *self, const uint64_t *wanted_us, uint64_t world_us)
{
    if (wanted_us != NULL) {
        self->lonely_looks = 0U;
        return (*wanted_us > self->now_us) ? *wanted_us : self->now_us;
    }
    if (self->lonely_looks < PATIENT_LOOKS) {
        self->lonely_looks++;
        return self->now_us;
    }
    const uint64_t elapsed_us = (world_us - self->looked_us) / self->time.slowness;
    return self->now_us + ((elapsed_us < BOX_CLOCK_STRIDE_US) ? elapsed_us : BOX_CLOCK_STRIDE_US);
}

uint32_t box_clock_look(box_clock_t *self, const uint64_t *wanted_us, uint64_t world_us)
{
    const uint64_t before_us = self->now_us;

    self->now_us = self->time.is_elastic ? elastic_now_us(self, wanted_us, world_us)
                                         : (world_us / self->time.slowness);
    self->looked_us = world_us;
    const uint64_t stride_us = self->now_us - before_us;
    const uint32_t most_us = self->time.is_elastic ? BOX_CLOCK_STRIDE_US : LIMIT_BOX_LEAP_US;
    return (stride_us < most_us) ? (uint32_t)stride_us : most_us;
}

void box_clock_hear(box_clock_t *self)
{
    self->lonely_looks = 0U;
}
