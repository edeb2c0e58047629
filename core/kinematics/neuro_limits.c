/* SPDX-License-Identifier: Apache-2.0 */
#include "neuro_limits.h"

#include "contract.h"
#include "fixed.h"

#include <stdbool.h>

/* Beyond this many ranges outside, all is equally far: keeps the product with the reciprocal below
 * 2^63. */
#define FARTHEST_RANGES INT64_C(64)

static void set_limit(neuro_limits_t *self, uint32_t index, int64_t minimum, int64_t maximum)
{
    static const char contract_module[] = "neuro_limits";
    REQUIRE(100U, minimum < maximum);
    const int64_t range = maximum - minimum;
    const uint64_t reciprocal_q56 = fixed_divide((uint64_t)NEURO_ONE_Q56, (uint64_t)range);
    self->limit[index].minimum = minimum;
    self->limit[index].maximum = maximum;
    self->limit[index].reciprocal_q56 = (int64_t)reciprocal_q56;
    self->limit[index].farthest = -range * FARTHEST_RANGES;
}

static neuro_result_t result_of(uint32_t index, bool is_maximum)
{
    neuro_result_t result = {STATUS_AXIS_LIMIT, 0U, is_maximum ? 1U : 0U};
    if (index == NEURO_LIMIT_SEPARATION) {
        result.status = STATUS_SEPARATION_LIMIT;
    } else if (index == NEURO_LIMIT_HEIGHT) {
        result.status = STATUS_UNREACHABLE_HEIGHT;
    } else {
        result.axis = (uint8_t)index;
    }
    return result;
}

int64_t neuro_limits_value(const axis_config_t *axis, int32_t ticks)
{
    const int64_t whole = axis->unit_per_tick_q16 / 65536;
    const int64_t fraction_q16 = axis->unit_per_tick_q16 % 65536;
    return (ticks * whole) + fixed_shift_rounded(ticks * fraction_q16, 16U);
}

void neuro_limits_init(neuro_limits_t *self, const robot_t *robot)
{
    const neuro_geometry_t *const geometry = &robot->neuro;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const axis = &robot->axes[i];
        set_limit(self, i, neuro_limits_value(axis, axis->minimum_ticks),
                  neuro_limits_value(axis, axis->maximum_ticks));
    }
    set_limit(self, NEURO_LIMIT_SEPARATION, geometry->minimum_separation_nm,
              geometry->maximum_separation_nm);
    set_limit(self, NEURO_LIMIT_HEIGHT, 1, (int64_t)geometry->side_link_nm - 1);
}

void neuro_margin_init(neuro_margin_t *self)
{
    self->margin_q56 = INT64_MAX;
    self->nearest = (neuro_result_t){STATUS_OK, 0U, 0U};
}

void neuro_margin_add(neuro_margin_t *self, const neuro_limits_t *limits, uint32_t index,
                      int64_t value)
{
    const neuro_limit_t *const limit = &limits->limit[index];
    const int64_t above_minimum = value - limit->minimum;
    const int64_t below_maximum = limit->maximum - value;
    const bool is_maximum = below_maximum < above_minimum;
    int64_t distance = is_maximum ? below_maximum : above_minimum;
    if (distance < limit->farthest) {
        distance = limit->farthest;
    }
    const int64_t margin_q56 = distance * limit->reciprocal_q56;
    if (margin_q56 < self->margin_q56) {
        self->margin_q56 = margin_q56;
        self->nearest = result_of(index, is_maximum);
    }
}

void neuro_margin_add_missed(neuro_margin_t *self, const neuro_limits_t *limits, uint32_t index,
                             int64_t value)
{
    const neuro_limit_t *const limit = &limits->limit[index];
    if ((value < limit->minimum) || (value > limit->maximum)) {
        neuro_margin_add(self, limits, index, value);
    }
}
