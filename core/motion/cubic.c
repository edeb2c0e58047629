/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/cubic.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

#define ONE_TICK_Q8 INT64_C(256)

/* Product in cubic_keeps_acceleration(); the robot compiler keeps the acceleration. */
#if LIMIT_ACCELERATION_MOST_TICKS_PER_S2 >                                                         \
    (INT64_MAX / (256 * LIMIT_TRAJECTORY_STEP_MOST_MS * LIMIT_TRAJECTORY_STEP_MOST_MS))
#error "The longest way at the most acceleration does not fit 64 bits."
#endif

/* A third of the way in `span_ms` at that speed, 8 fraction bits. */
static int64_t third_q8(int32_t speed_ticks_per_s, uint32_t span_ms)
{
    return fixed_divide_by((int64_t)speed_ticks_per_s * (int64_t)span_ms * 32, 375U);
}

static int64_t between(int64_t a, int64_t b, uint32_t share_q20)
{
    return a + (((b - a) * (int64_t)share_q20) / (int64_t)CUBIC_ONE_Q20);
}

void cubic_set(cubic_t *self, const cubic_end_t *from, const cubic_end_t *to, uint32_t span_ms)
{
    self->span_ms = span_ms;
    self->at_q8[0] = (int64_t)from->ticks * ONE_TICK_Q8;
    self->at_q8[3] = (int64_t)to->ticks * ONE_TICK_Q8;
    self->at_q8[1] = self->at_q8[0] + third_q8(from->speed_ticks_per_s, span_ms);
    self->at_q8[2] = self->at_q8[3] - third_q8(to->speed_ticks_per_s, span_ms);
}

uint32_t cubic_share_q20(uint32_t time_us, uint32_t span_ms)
{
    return (uint32_t)fixed_divide((uint64_t)time_us * CUBIC_ONE_Q20, (uint64_t)span_ms * 1000U);
}

/* The last two points of de Casteljau's halving: the curve is between them, and goes their way. */
static void narrow(const cubic_t *self, uint32_t share_q20, int64_t last_q8[2])
{
    const int64_t first = between(self->at_q8[0], self->at_q8[1], share_q20);
    const int64_t middle = between(self->at_q8[1], self->at_q8[2], share_q20);
    const int64_t third = between(self->at_q8[2], self->at_q8[3], share_q20);
    last_q8[0] = between(first, middle, share_q20);
    last_q8[1] = between(middle, third, share_q20);
}

int32_t cubic_position_ticks(const cubic_t *self, uint32_t share_q20)
{
    int64_t last_q8[2];
    narrow(self, share_q20, last_q8);
    return fixed_saturate(fixed_shift_rounded(between(last_q8[0], last_q8[1], share_q20), 8U));
}

int32_t cubic_speed_ticks_per_s_q8(const cubic_t *self, uint32_t share_q20)
{
    int64_t last_q8[2];
    narrow(self, share_q20, last_q8);
    return fixed_saturate(
        fixed_divide_rounded((last_q8[1] - last_q8[0]) * 3000, (int64_t)self->span_ms));
}

int32_t cubic_point_ticks(const cubic_t *self, uint32_t index)
{
    return fixed_saturate(fixed_shift_rounded(self->at_q8[index % CUBIC_POINTS], 8U));
}

bool cubic_keeps_speed(const cubic_t *self, int32_t speed_ticks_per_s)
{
    const int64_t first = self->at_q8[1] - self->at_q8[0];
    const int64_t middle = self->at_q8[2] - self->at_q8[1];
    const int64_t last = self->at_q8[3] - self->at_q8[2];
    const int64_t inner =
        fixed_larger(fixed_magnitude(first + middle), fixed_magnitude(middle + last)) * 2;
    const int64_t outer = fixed_larger(fixed_magnitude(first), fixed_magnitude(last)) * 4;
    const int64_t most =
        fixed_larger(fixed_larger(inner, outer), fixed_magnitude(first + (2 * middle) + last));
    return (most * 750) <= ((int64_t)speed_ticks_per_s * (int64_t)self->span_ms * ONE_TICK_Q8);
}

bool cubic_keeps_acceleration(const cubic_t *self, int32_t ticks_per_s2)
{
    const int64_t begin = (self->at_q8[2] - self->at_q8[1]) - (self->at_q8[1] - self->at_q8[0]);
    const int64_t end = (self->at_q8[3] - self->at_q8[2]) - (self->at_q8[2] - self->at_q8[1]);
    const int64_t most = fixed_larger(fixed_magnitude(begin), fixed_magnitude(end)) - ONE_TICK_Q8;
    const int64_t span_ms = (int64_t)self->span_ms;
    return (most * 6000000) <= ((int64_t)ticks_per_s2 * ONE_TICK_Q8 * span_ms * span_ms);
}
