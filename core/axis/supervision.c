/* SPDX-License-Identifier: Apache-2.0 */
#include "supervision.h"

#include "fixed.h"
#include "requirement_limits.h"

#include <string.h>

#define PLACE_US 100000U
/* From the drive word to a motor at rest. */
#define REST_US 10000U

static int64_t error_ticks(const supervision_view_t *view)
{
    const int64_t error = (int64_t)view->setpoint_ticks - (int64_t)view->position_ticks;
    return (error < 0) ? -error : error;
}

/* The motor is asked for more than a trembling. */
static bool is_pushing(const axis_config_t *config, const supervision_view_t *view)
{
    const int64_t error = error_ticks(view);
    return view->is_driven && (error >= (int64_t)LIMIT_STALL_PROGRESS_TICKS) &&
           (error > (int64_t)config->deadband_ticks);
}

/* Way since the mark in the direction of the drive, not of the set-point: that may be overtaken for
 * a while. */
static int64_t way_ticks(const supervision_t *self, const supervision_view_t *view)
{
    const int64_t way = (int64_t)view->position_ticks - (int64_t)self->mark_ticks;
    return view->is_upwards ? way : -way;
}

static void watch_progress(supervision_t *self, const supervision_view_t *view)
{
    const uint32_t direction = view->is_upwards ? 1U : 0U;
    const bool has_turned = direction != self->is_upwards;
    self->is_upwards = direction;
    if (has_turned || (way_ticks(self, view) >= (int64_t)LIMIT_STALL_PROGRESS_TICKS)) {
        (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_PROGRESS);
        self->mark_ticks = view->position_ticks;
    }
    (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_DRIVEN);
}

static bool is_stalled(supervision_t *self, const axis_config_t *config,
                       const supervision_view_t *view)
{
    const uint32_t actions = stall_watchdog_chart_advance(&self->stall, view->elapsed_us);
    if ((actions & STALL_WATCHDOG_ACTION_REPORT_STALL) != 0U) {
        return true;
    }
    if (is_pushing(config, view)) {
        watch_progress(self, view);
    } else {
        (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_NOT_DRIVEN);
        self->mark_ticks = view->position_ticks;
    }
    return false;
}

static bool is_astray(const axis_config_t *config, const supervision_view_t *view)
{
    return view->is_driven && (error_ticks(view) > (int64_t)config->following_error_ticks);
}

static bool is_backwards(supervision_t *self, const supervision_view_t *view)
{
    const int64_t way = way_ticks(self, view);
    const bool is_wrong = view->is_driven && (way <= -(int64_t)LIMIT_WRONG_WAY_TICKS);
    if (is_wrong) {
        self->backwards_ticks = (int32_t)-way;
    }
    return is_wrong;
}

int32_t supervision_rest_ticks(const axis_config_t *config)
{
    const int64_t way = (config->unit == (uint8_t)AXIS_UNIT_MM) ? (int64_t)LIMIT_REST_WAY_NM
                                                                : (int64_t)LIMIT_REST_WAY_BAM;
    return fixed_saturate((way * 65536) / config->unit_per_tick_q16);
}

static void settle(supervision_t *self, const supervision_view_t *view)
{
    for (uint32_t i = 0U; i < SUPERVISION_PLACES; i++) {
        self->places_ticks[i] = view->position_ticks;
    }
    self->place_us = 0U;
}

static void remember_place(supervision_t *self, const supervision_view_t *view)
{
    self->place_us += view->elapsed_us;
    if (self->place_us >= PLACE_US) {
        self->place_us = 0U;
        self->place = (self->place + 1U) % SUPERVISION_PLACES;
        self->places_ticks[self->place] = view->position_ticks;
    }
}

/* From the place of the last second that is farthest from here. */
static int32_t way_while_off(const supervision_t *self, const supervision_view_t *view)
{
    int64_t farthest = 0;
    for (uint32_t i = 0U; i < SUPERVISION_PLACES; i++) {
        const int64_t way = (int64_t)view->position_ticks - (int64_t)self->places_ticks[i];
        if ((way > farthest) || (-way > farthest)) {
            farthest = (way < 0) ? -way : way;
        }
    }
    return fixed_saturate(farthest);
}

static bool is_moving_while_off(supervision_t *self, const axis_config_t *config,
                                const supervision_view_t *view)
{
    const uint32_t more_us = view->is_off ? view->elapsed_us : 0U;
    self->off_us = view->is_off ? self->off_us : 0U;
    self->off_us += (self->off_us < REST_US) ? more_us : 0U;
    if (self->off_us < REST_US) {
        settle(self, view);
        return false;
    }
    remember_place(self, view);
    self->off_ticks = way_while_off(self, view);
    return self->off_ticks > supervision_rest_ticks(config);
}

static uint32_t note(bool is_found, uint32_t name)
{
    return is_found ? name : 0U;
}

void supervision_init(supervision_t *self)
{
    (void)memset(self, 0, sizeof *self);
    stall_watchdog_chart_init(&self->stall);
}

void supervision_reset(supervision_t *self)
{
    (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_RESET);
}

static int32_t shifted(int32_t place_ticks, int32_t ticks)
{
    return fixed_saturate((int64_t)place_ticks + (int64_t)ticks);
}

void supervision_shift(supervision_t *self, int32_t ticks)
{
    self->mark_ticks = shifted(self->mark_ticks, ticks);
    for (uint32_t i = 0U; i < SUPERVISION_PLACES; i++) {
        self->places_ticks[i] = shifted(self->places_ticks[i], ticks);
    }
}

uint32_t supervision_step(supervision_t *self, const axis_config_t *config,
                          const supervision_view_t *view)
{
    uint32_t notes = 0U;
    notes |= note(is_stalled(self, config, view), AXIS_NOTE_STALLED);
    notes |= note(is_astray(config, view), AXIS_NOTE_FOLLOWING_ERROR);
    notes |= note(is_backwards(self, view), AXIS_NOTE_WRONG_WAY);
    notes |= note(is_moving_while_off(self, config, view), AXIS_NOTE_MOVED_OFF);
    return notes;
}
