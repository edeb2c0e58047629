/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/write/sweep_keeper.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#define BATCH 64U

static void begin(sweep_keeper_t *self, uint32_t axis)
{
    const robot_t *robot = self->robot;
    (void)memset(&self->curve, 0, sizeof self->curve);
    (void)memcpy(self->curve.robot, robot->name, sizeof self->curve.robot);
    (void)memcpy(self->curve.axis, robot->axes[axis].name, sizeof self->curve.axis);
    self->curve.robot_crc = robot->crc;
    self->curve.card_firmware = robot->card_firmware;
    self->is_gathering = true;
}

static void add_point(sweep_keeper_t *self, int32_t down_ticks)
{
    self->point.down_ticks = down_ticks;
    if (self->curve.count < LIMIT_SWEEP_POINTS) {
        self->curve.points[self->curve.count] = self->point;
        self->curve.count++;
    }
}

static bool end(sweep_keeper_t *self, const exchange_event_t *event)
{
    self->is_gathering = false;
    self->curve.end = (uint32_t)event->event.value;
    self->curve.ended_us = event->utc_us;
    return sweep_curve_keep(&self->curve, self->robot, self->directory);
}

bool sweep_keeper_hear(sweep_keeper_t *self, const exchange_event_t *event, uint32_t lost)
{
    const event_t *reported = &event->event;
    bool is_kept = true;
    self->is_gathering = self->is_gathering && (lost == 0U);
    if ((reported->id == (uint32_t)EVENT_SWEEP_BEGUN) &&
        (reported->subject < self->robot->axis_count)) {
        begin(self, reported->subject);
    } else if (!self->is_gathering) {
        /* It is of no sweep that was heard from its beginning. */
    } else if (reported->id == (uint32_t)EVENT_SWEEP_WORD) {
        self->point.hertz = reported->value;
    } else if (reported->id == (uint32_t)EVENT_SWEEP_UPWARDS) {
        self->point.up_ticks = reported->value;
    } else if (reported->id == (uint32_t)EVENT_SWEEP_DOWNWARDS) {
        add_point(self, reported->value);
    } else if (reported->id == (uint32_t)EVENT_SWEEP_ENDED) {
        is_kept = end(self, event);
    } else {
        /* Something else. */
    }
    return is_kept;
}

void sweep_keeper_drain(sweep_keeper_t *self, const exchange_t *exchange)
{
    static exchange_event_t events[BATCH];
    uint32_t count;
    do {
        uint32_t lost = 0U;
        count = exchange_read_events(exchange, &self->next, events, BATCH, &lost);
        for (uint32_t i = 0U; i < count; i++) {
            if (!sweep_keeper_hear(self, &events[i], (i == 0U) ? lost : 0U)) {
                (void)fprintf(stderr, "recorder: the sweep cannot be kept in %s (%s).\n",
                              self->directory, strerror(errno));
            }
        }
    } while (count == BATCH);
}
