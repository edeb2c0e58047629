/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/data/source.h"

#include "common/drive_terms.h"
#include "robot/robot_cards.h"

#include <stdio.h>
#include <string.h>

#define DECIMALS_PERCENT 3

static source_t source_of_axis(const robot_t *robot, uint32_t axis)
{
    source_t self = {.says = "An axis.",
                     .fields = fields_snapshot_axis,
                     .offset = offsetof(snapshot_t, axes) + (axis * sizeof(snapshot_axis_t)),
                     .axis = &robot->axes[axis]};

    (void)snprintf(self.topic, sizeof self.topic, "/axes/%s", self.axis->name);
    (void)snprintf(self.prefix, sizeof self.prefix, "%s_", self.axis->name);
    return self;
}

static source_t source_of_card(uint32_t slot)
{
    source_t self = {.says = "A daughter card.",
                     .fields = fields_snapshot_card,
                     .offset = offsetof(snapshot_t, cards) + (slot * sizeof(snapshot_card_t))};

    (void)snprintf(self.topic, sizeof self.topic, "/cards/%u", (unsigned)slot);
    (void)snprintf(self.prefix, sizeof self.prefix, "card%u_", (unsigned)slot);
    return self;
}

uint32_t source_find(const robot_t *robot, source_t sources[SOURCES])
{
    uint32_t count = 1U;

    sources[0] = (source_t){.says = "What is of no axis and no card.",
                            .fields = fields_snapshot,
                            .topic = "/state",
                            .prefix = ""};
    for (uint32_t axis = 0U; axis < robot->axis_count; axis++) {
        sources[count] = source_of_axis(robot, axis);
        count++;
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (robot_cards_type(robot, slot) != (uint32_t)CARD_TYPE_NONE) {
            sources[count] = source_of_card(slot);
            count++;
        }
    }
    return count;
}

void source_report(const source_t *self, const snapshot_t *snapshot, series_sink_t *sink, void *to)
{
    const uint8_t *const from = (const uint8_t *)snapshot + self->offset;

    series_report(self->fields, from, self->axis, sink, to);
    if (self->axis != NULL) {
        snapshot_axis_t axis;
        (void)memcpy(&axis, from, sizeof axis);
        const series_t output = {.name = "output_percent",
                                 .says = "The drive word in percent of its largest, with the sign "
                                         "of the way; 0 while it is not driven.",
                                 .number = drive_terms_percent(self->axis, &axis),
                                 .decimals = DECIMALS_PERCENT};
        sink(to, &output);
    }
}
