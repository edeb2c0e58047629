/* SPDX-License-Identifier: Apache-2.0 */
#include "supervision.h"

#include "requirement_limits.h"

#include <string.h>

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

uint32_t supervision_step(supervision_t *self, const axis_config_t *config,
                          const supervision_view_t *view)
{
    uint32_t notes = 0U;
    notes |= note(is_stalled(self, config, view), AXIS_NOTE_STALLED);
    notes |= note(is_astray(config, view), AXIS_NOTE_FOLLOWING_ERROR);
    notes |= note(is_backwards(self, view), AXIS_NOTE_WRONG_WAY);
    return notes;
}
