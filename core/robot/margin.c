/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/margin.h"

#include "base/contract.h"
#include "base/fixed.h"

#include <stdbool.h>

/* Beyond this many ranges outside, all is equally far: keeps the product with the reciprocal below
 * 2^63. */
#define FARTHEST_RANGES INT64_C(64)

void margin_set_limit(joint_limits_t *self, uint32_t index, status_t status, int64_t minimum,
                      int64_t maximum)
{
    static const char contract_module[] = "margin";
    REQUIRE(100U, minimum < maximum);
    const int64_t range = maximum - minimum;
    const uint64_t reciprocal_q56 = fixed_divide((uint64_t)MARGIN_ONE_Q56, (uint64_t)range);
    joint_limit_t *const limit = &self->limit[index];
    limit->minimum = minimum;
    limit->maximum = maximum;
    limit->reciprocal_q56 = (int64_t)reciprocal_q56;
    limit->farthest = -range * FARTHEST_RANGES;
    self->status[index] = status;
}

void margin_set_axes(joint_limits_t *self, const robot_t *robot)
{
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const axis = &robot->axes[i];
        margin_set_limit(self, i, STATUS_AXIS_LIMIT, joints_value(axis, axis->minimum_ticks),
                         joints_value(axis, axis->maximum_ticks));
    }
}

solution_t margin_limit(const margin_t *self, const joint_limits_t *limits)
{
    const status_t status = limits->status[self->nearest];
    const uint8_t axis = (status == STATUS_AXIS_LIMIT) ? (uint8_t)self->nearest : 0U;
    return (solution_t){.status = status, .axis = axis, .is_maximum = self->is_maximum};
}

void margin_init(margin_t *self)
{
    self->margin_q56 = INT64_MAX;
    self->nearest = 0U;
    self->is_maximum = 0U;
}

void margin_add(margin_t *self, const joint_limits_t *limits, uint32_t index, int64_t value)
{
    const joint_limit_t *const limit = &limits->limit[index];
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
        self->nearest = index;
        self->is_maximum = is_maximum ? 1U : 0U;
    }
}

void margin_add_missed(margin_t *self, const joint_limits_t *limits, uint32_t index, int64_t value)
{
    const joint_limit_t *const limit = &limits->limit[index];
    if ((value < limit->minimum) || (value > limit->maximum)) {
        margin_add(self, limits, index, value);
    }
}
