/* SPDX-License-Identifier: Apache-2.0 */
#include "saved/saved_plan.h"

#include "axis/encoder.h"
#include "axis/supervision.h"
#include "base/fixed.h"
#include "charts/axis_chart.h"

#include <string.h>

static bool is_within_rest(const axis_config_t *config, int64_t way_ticks)
{
    const int64_t rest_ticks = (int64_t)supervision_rest_ticks(config);
    return (way_ticks <= rest_ticks) && (way_ticks >= -rest_ticks);
}

static bool is_homed(const snapshot_axis_t *shown)
{
    return (shown->reference == (uint32_t)AXIS_REFERENCE_TAKEN) ||
           (shown->reference == (uint32_t)AXIS_REFERENCE_VERIFIED);
}

/* Why an axis is restored whose counter shows nothing against it. */
static saved_why_t why_restored(const saved_t *saved, bool is_same_power_on)
{
    saved_why_t why = SAVED_WHY_COUNTS_AGREE;
    if (saved->origin == SAVED_OLD_LIST) {
        why = SAVED_WHY_OLD_LIST;
    } else if (saved->origin == SAVED_UNSEALED) {
        why = SAVED_WHY_UNSEALED;
    } else if (!is_same_power_on) {
        why = SAVED_WHY_OTHER_POWER_ON;
    } else {
        /* The best there is. */
    }
    return why;
}

static saved_row_t row_of(const saved_t *saved, const snapshot_t *snapshot,
                          const axis_config_t *config, uint32_t index)
{
    const kept_axis_t *kept = &saved->record.axes[index];
    const snapshot_axis_t *shown = &snapshot->axes[index];
    const bool is_same_power_on =
        (saved->origin != SAVED_OLD_LIST) && (saved->record.power_on == snapshot->power_on);
    const int32_t way_ticks =
        is_same_power_on ? encoder_way(config, kept->reading_ticks, shown->reading_ticks) : 0;
    saved_row_t row = {.why = why_restored(saved, is_same_power_on),
                       .now_ticks = shown->position_ticks,
                       .saved_ticks = kept->position_ticks};
    const bool is_miscounted = ((saved->miscounted >> index) & 1U) != 0U;
    row.next_ticks = fixed_saturate((int64_t)kept->position_ticks + (int64_t)way_ticks);
    const int64_t away_ticks = (int64_t)row.next_ticks - (int64_t)row.now_ticks;
    if (kept->grade != (uint32_t)KEPT_KNOWN) {
        row.why = SAVED_WHY_NOT_KNOWN;
    } else if (!is_within_rest(config, way_ticks) && is_miscounted) {
        row.why = SAVED_WHY_MISCOUNTED;
        row.next_ticks = row.saved_ticks;
    } else if (!is_within_rest(config, way_ticks)) {
        row.why = SAVED_WHY_MOVED;
    } else if (is_homed(shown) && is_within_rest(config, away_ticks)) {
        row.why = SAVED_WHY_STANDS_THERE;
    } else {
        /* It is restored. */
    }
    return row;
}

bool saved_plan_restores(saved_why_t why)
{
    return why <= SAVED_WHY_MISCOUNTED;
}

void saved_plan_make(saved_plan_t *self, const saved_t *saved, const snapshot_t *snapshot,
                     const robot_t *robot)
{
    (void)memset(self, 0, sizeof *self);
    self->axis_count = robot->axis_count;
    self->power_on = snapshot->power_on;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        self->rows[i] = row_of(saved, snapshot, &robot->axes[i], i);
        self->axes |= saved_plan_restores(self->rows[i].why) ? (1U << i) : 0U;
    }
}

bool saved_plan_fits(const saved_plan_t *self, const saved_t *saved)
{
    uint32_t miscounted = 0U;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        miscounted |= (self->rows[i].why == SAVED_WHY_MISCOUNTED) ? (1U << i) : 0U;
    }
    return miscounted == saved->miscounted;
}

bool saved_plan_holds(const saved_plan_t *self, const saved_plan_t *now, const robot_t *robot)
{
    bool is_same = (self->axes == now->axes) && (self->power_on == now->power_on);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const int64_t way_ticks =
            (int64_t)now->rows[i].now_ticks - (int64_t)self->rows[i].now_ticks;
        is_same = is_same && is_within_rest(&robot->axes[i], way_ticks);
    }
    return is_same;
}
