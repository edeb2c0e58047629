/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/profile.h"

#include "base/contract.h"
#include "base/fixed.h"
#include "limits/requirement_limits.h"

#include <string.h>

#define CYCLES_PER_S (INT64_C(1000000) / (int64_t)LIMIT_CYCLE_US)

static const char contract_module[] = "profile";

static int64_t smaller(int64_t a, int64_t b)
{
    return (a < b) ? a : b;
}

static int64_t divide_up(int64_t numerator, int64_t denominator)
{
    return (numerator + denominator - 1) / denominator;
}

static int64_t square_root_up(int64_t value)
{
    int64_t root = (int64_t)fixed_square_root((uint64_t)value);
    if ((root * root) < value) {
        root++;
    }
    return root;
}

static int64_t total_cycles(const profile_t *self)
{
    return (2 * (int64_t)self->ramp_cycles) + (int64_t)self->cruise_cycles;
}

static void rest_at(profile_t *self, const int32_t position_ticks[ROBOT_AXIS_MAX])
{
    (void)memcpy(self->start_ticks, position_ticks, sizeof self->start_ticks);
    (void)memcpy(self->end_ticks, position_ticks, sizeof self->end_ticks);
    self->ramp_cycles = 0U;
    self->cruise_cycles = 0U;
    self->cycle = 0U;
}

void profile_plan(profile_t *self, const robot_t *robot, const int32_t start_ticks[ROBOT_AXIS_MAX],
                  const int32_t end_ticks[ROBOT_AXIS_MAX], uint32_t speed_percent)
{
    REQUIRE(100U, (speed_percent >= 1U) && (speed_percent <= 100U));
    int64_t ramp_and_cruise = 0; /* R + C */
    int64_t product = 0;         /* R (R + C) */
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const axis = &robot->axes[i];
        const int64_t way = fixed_magnitude((int64_t)end_ticks[i] - (int64_t)start_ticks[i]);
        const int64_t speed = (int64_t)axis->speed_ticks_per_s * (int64_t)speed_percent *
                              (int64_t)LIMIT_PROFILE_SPEED_PERCENT;
        ramp_and_cruise =
            fixed_larger(ramp_and_cruise, divide_up(way * CYCLES_PER_S * 10000, speed));
        product = fixed_larger(product, divide_up(way * CYCLES_PER_S * CYCLES_PER_S,
                                                  (int64_t)axis->acceleration_ticks_per_s2));
    }
    rest_at(self, start_ticks);
    (void)memcpy(self->end_ticks, end_ticks, sizeof self->end_ticks);
    if (product > 0) {
        ramp_and_cruise = fixed_larger(ramp_and_cruise, square_root_up(product));
        const int64_t ramp = divide_up(product, ramp_and_cruise);
        const int64_t cruise = ramp_and_cruise - ramp;
        self->ramp_cycles = (uint32_t)ramp;
        self->cruise_cycles = (uint32_t)cruise;
    }
}

void profile_step(profile_t *self)
{
    if (!profile_is_finished(self)) {
        self->cycle++;
    }
}

bool profile_is_finished(const profile_t *self)
{
    return (int64_t)self->cycle >= total_cycles(self);
}

int32_t profile_position_ticks(const profile_t *self, uint32_t axis)
{
    const int64_t ramp = (int64_t)self->ramp_cycles;
    const int64_t plateau = ramp + (int64_t)self->cruise_cycles;
    const int64_t k = (int64_t)self->cycle;
    const int64_t left = total_cycles(self) - k;
    const int64_t start = (int64_t)self->start_ticks[axis];
    const int64_t end = (int64_t)self->end_ticks[axis];
    const int64_t way = end - start;
    if (left == 0) {
        return self->end_ticks[axis];
    }
    int64_t position = 0;
    if (k < ramp) {
        position = start + fixed_divide_rounded(way * k * k, 2 * ramp * plateau);
    } else if (left < ramp) {
        position = end - fixed_divide_rounded(way * left * left, 2 * ramp * plateau);
    } else {
        position = start + fixed_divide_rounded(way * ((2 * k) - ramp), 2 * plateau);
    }
    return (int32_t)position;
}

int32_t profile_speed_ticks_per_s_q8(const profile_t *self, uint32_t axis)
{
    const int64_t ramp = (int64_t)self->ramp_cycles;
    const int64_t plateau = ramp + (int64_t)self->cruise_cycles;
    const int64_t k = (int64_t)self->cycle;
    const int64_t left = total_cycles(self) - k;
    const int64_t way = (int64_t)self->end_ticks[axis] - (int64_t)self->start_ticks[axis];
    if (left == 0) {
        return 0;
    }
    const int64_t share = smaller(ramp, smaller(k, left)); /* of the peak, in 1/ramp */
    return fixed_saturate(fixed_divide_rounded(way * share * 256 * CYCLES_PER_S, ramp * plateau));
}
