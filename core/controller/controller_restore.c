/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_restore.h"

#include "base/contract.h"
#include "base/fixed.h"

static const char contract_module[] = "controller";

/* Its counts are to be compared: what is lost stays so whatever they say, and so does what has a
 * grade that nobody knows. */
static bool is_awaited(const controller_t *self, uint32_t index)
{
    const uint32_t grade = self->kept.axes[index].grade;
    return (self->kept.verdict == (uint32_t)KEPT_GOOD) &&
           ((grade == (uint32_t)KEPT_FRESH) || (grade == (uint32_t)KEPT_KNOWN));
}

void controller_restore(controller_t *self, const kept_positions_t *kept)
{
    REQUIRE(101U, self->has_started == 0U);
    self->kept = *kept;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        if ((kept->verdict != (uint32_t)KEPT_NOTHING) && !is_awaited(self, i)) {
            axis_forget(&self->axes[i]);
        }
    }
    controller_seal(self);
}

static void restore(controller_t *self, const cycle_t *cycle, uint32_t index,
                    int32_t position_ticks)
{
    if (self->kept.axes[index].grade == (uint32_t)KEPT_KNOWN) {
        axis_restore(&self->axes[index], &cycle->robot->axes[index], position_ticks);
        controller_note(self, cycle, EVENT_AXIS_RESTORED, index, position_ticks);
    }
}

/* It was moved, or its counter was. */
static void contradict(controller_t *self, const cycle_t *cycle, uint32_t index,
                       int32_t position_ticks, int32_t way_ticks)
{
    axis_forget(&self->axes[index]);
    if (self->kept.axes[index].grade == (uint32_t)KEPT_KNOWN) {
        axis_remember(&self->axes[index], position_ticks);
    }
    controller_note(self, cycle, EVENT_AXIS_CONTRADICTED, index, way_ticks);
}

void controller_compare(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const axis_t *const axis = &self->axes[index];
    const axis_config_t *const config = &cycle->robot->axes[index];
    if (!is_awaited(self, index) || (axis->encoder.has_reading == 0U)) {
        return;
    }
    const kept_axis_t *const kept = &self->kept.axes[index];
    const int32_t way_ticks = encoder_way(config, kept->reading_ticks, axis->encoder.reading);
    const int64_t rest_ticks = (int64_t)supervision_rest_ticks(config);
    const int32_t position_ticks =
        fixed_saturate((int64_t)kept->position_ticks + (int64_t)way_ticks);
    if (((int64_t)way_ticks <= rest_ticks) && ((int64_t)way_ticks >= -rest_ticks)) {
        restore(self, cycle, index, position_ticks);
    } else {
        contradict(self, cycle, index, position_ticks, way_ticks);
    }
    self->kept.axes[index].grade = (uint32_t)KEPT_LOST;
}

uint32_t controller_count_awaited(const controller_t *self)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        count += is_awaited(self, i) ? 1U : 0U;
    }
    return count;
}
