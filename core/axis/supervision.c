/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/supervision.h"

#include "axis/encoder.h"
#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "motion/motor_heat.h"
#include "robot/joints.h"

#include <string.h>

/* Between two of the places that are remembered: all of them are of the last second. */
#define PLACE_US 100000U
#define US_PER_S 1000000U
/* Drives that a card may have applied. */
#define DRIVE_OFF 1U
#define DRIVE_DOWN 2U
#define DRIVE_UP 4U

/* Distance of the axis from its set-point. */
static uint32_t error_ticks(const supervision_view_t *view)
{
    return (view->setpoint_ticks < view->position_ticks)
               ? ((uint32_t)view->position_ticks - (uint32_t)view->setpoint_ticks)
               : ((uint32_t)view->setpoint_ticks - (uint32_t)view->position_ticks);
}

/* The motor is commanded beyond its dither. */
static bool is_pushing(const axis_config_t *config, const supervision_view_t *view)
{
    const uint32_t error = error_ticks(view);
    return view->is_driven && (error >= LIMIT_STALL_PROGRESS_TICKS) &&
           ((int64_t)error > (int64_t)config->deadband_ticks);
}

/* Way since the mark in the direction of the drive, not of the set-point: that may be overtaken for
 * a while. */
static int64_t way_ticks(const supervision_t *self, const supervision_view_t *view)
{
    const int64_t way = (int64_t)view->position_ticks - (int64_t)self->sealed.mark_ticks;
    return view->is_upwards ? way : -way;
}

static void watch_progress(supervision_t *self, const supervision_view_t *view)
{
    const uint16_t direction = view->is_upwards ? 1U : 0U;
    const bool has_turned = direction != self->sealed.is_upwards;
    self->sealed.is_upwards = direction;
    if (has_turned || (way_ticks(self, view) >= (int64_t)LIMIT_STALL_PROGRESS_TICKS)) {
        (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_PROGRESS);
        self->sealed.mark_ticks = view->position_ticks;
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
        if (self->stall.state != STALL_WATCHDOG_STATE_IDLE) { /* STALL-I09 */
            (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_NOT_DRIVEN);
        }
        self->sealed.mark_ticks = view->position_ticks;
    }
    return false;
}

static bool is_astray(const supervision_view_t *view)
{
    return view->is_driven && ((int64_t)error_ticks(view) > (int64_t)view->following_error_ticks);
}

static bool is_backwards(supervision_t *self, const supervision_view_t *view)
{
    const int64_t way = way_ticks(self, view);
    const bool is_wrong = view->is_driven && (way <= -(int64_t)LIMIT_WRONG_WAY_TICKS);
    if (is_wrong) {
        self->sealed.backwards_ticks = (int32_t)-way;
    }
    return is_wrong;
}

int32_t supervision_rest_ticks(const axis_config_t *config)
{
    return fixed_saturate(joints_ticks_within(config, LIMIT_REST_WAY_NM, LIMIT_REST_WAY_BAM));
}

static int64_t due_ticks(const supervision_t *self)
{
    return ((self->sealed.due_q16 < 0) ? -self->sealed.due_q16 : self->sealed.due_q16) / 65536;
}

/* The motor was driven, and nothing was counted in its direction. A pause does not
 * clear the deficit. */
static bool is_silent(supervision_t *self, const axis_config_t *config, const count_cycle_t *cycle)
{
    if ((cycle->counted_ticks != 0) &&
        ((cycle->counted_ticks * (int64_t)self->sealed.account.direction) > 0)) {
        self->sealed.due_q16 = 0;
        self->sealed.silent_us = 0U;
        return false;
    }
    self->sealed.due_q16 += cycle->model_q16;
    if (self->sealed.due_q16 == 0) {
        return false;
    }
    const bool is_due = (cycle->model_q16 != 0) && (due_ticks(self) >= (int64_t)LIMIT_SILENT_TICKS);
    self->sealed.silent_us += is_due ? cycle->elapsed_us : 0U;
    return (self->sealed.silent_us >= LIMIT_SILENT_TIME_US) ||
           joints_is_beyond(config, due_ticks(self) + 1, LIMIT_BLIND_WAY_NM, LIMIT_BLIND_WAY_BAM);
}

void supervision_settle(supervision_t *self)
{
    self->sealed.due_q16 = 0;
    self->sealed.silent_us = 0U;
    count_balance_settle(&self->sealed.account);
    edge_spacing_settle(&self->sealed.pace);
}

/* Without any count the fault is NO_COUNTS, not WRONG_SPEED. The sum starts anew once the fault is
 * reported: the reference is lost then. */
static uint32_t watch_counts(supervision_t *self, const axis_config_t *config,
                             const count_cycle_t *cycle)
{
    const bool is_wrong = count_balance_step(&self->sealed.account, config, cycle);
    const bool is_none = is_silent(self, config, cycle);
    if (!is_none && !is_wrong) {
        return 0U;
    }
    const int64_t due = due_ticks(self);
    self->sealed.missing_ticks = fixed_saturate(due);
    supervision_settle(self);
    return (is_none || (due >= (int64_t)LIMIT_SILENT_TICKS)) ? AXIS_NOTE_NO_COUNTS
                                                             : AXIS_NOTE_WRONG_SPEED;
}

/* Mean speed of the last `age_us` of a cycle at the start of which it had another one. A speed that
 * changes by less than a 32nd in a cycle is steady. */
static int64_t mean_after(int64_t before_q8, int64_t speed_q8, uint32_t age_us, uint32_t elapsed_us)
{
    const int64_t gained_q8 = speed_q8 - before_q8;
    if ((fixed_magnitude(gained_q8) * 32) < fixed_magnitude(speed_q8)) {
        return speed_q8;
    }
    /* A cycle of drive is LIMIT_CARD_WATCHDOG_US at most: this is in 32 bits. */
    const uint32_t gaining_us = (age_us < elapsed_us) ? age_us : elapsed_us;
    const uint32_t share_q16 = (gaining_us * 65536U) / elapsed_us;
    return speed_q8 - ((gained_q8 * (int64_t)share_q16) / 131072);
}

/* Way of the model in that time. */
static uint32_t way_after(int64_t before_q8, int64_t speed_q8, uint32_t age_us, uint32_t elapsed_us)
{
    const int64_t mean_q8 = mean_after(before_q8, speed_q8, age_us, elapsed_us);
    const int64_t way_q16 = fixed_divide_by(mean_q8 * 4 * (int64_t)age_us, US_PER_S / 64U);
    return (uint32_t)((way_q16 < 0) ? -way_q16 : way_q16);
}

/* Before count_balance_step(): that one knows the direction of the cycle before. */
static bool is_uneven(supervision_t *self, const supervision_view_t *view, int64_t before_q8,
                      const count_cycle_t *cycle)
{
    const bool is_upwards = cycle->model_q16 > 0;
    if (cycle->model_q16 == 0) {
        if (cycle->counted_ticks != 0) {
            edge_spacing_begin(&self->sealed.pace);
        }
        return false;
    }
    const int64_t way_q16 = is_upwards ? cycle->model_q16 : -cycle->model_q16;
    const int32_t ticks = fixed_saturate(is_upwards ? cycle->counted_ticks : -cycle->counted_ticks);
    if ((ticks < 0) || ((self->sealed.account.direction > 0) != is_upwards) ||
        (view->edge_age_us == ENCODER_AGE_UNKNOWN) || (self->sealed.account.unsure_us != 0U)) {
        edge_spacing_begin(&self->sealed.pace);
        return false;
    }
    const int64_t speed_q8 =
        motor_heat_slow(view->lost_q16, self->sealed.model.speed_ticks_per_s_q8);
    const edge_spacing_view_t pace = {
        .way_q16 = (uint32_t)way_q16,
        .after_q16 =
            (ticks > 0) ? way_after(before_q8, speed_q8, view->edge_age_us, cycle->elapsed_us) : 0U,
        .ticks = (uint32_t)ticks,
    };
    return edge_spacing_step(&self->sealed.pace, &pace);
}

static void settle(supervision_t *self, const supervision_view_t *view)
{
    for (uint32_t i = 0U; i < SUPERVISION_PLACES; i++) {
        self->sealed.places_ticks[i] = view->position_ticks;
    }
    self->sealed.lowest_ticks = view->position_ticks;
    self->sealed.highest_ticks = view->position_ticks;
    self->sealed.place_us = 0U;
}

static void remember_place(supervision_t *self, const supervision_view_t *view)
{
    self->sealed.place_us += view->elapsed_us;
    if (self->sealed.place_us < PLACE_US) {
        return;
    }
    self->sealed.place_us = 0U;
    self->sealed.place = (self->sealed.place + 1U) % SUPERVISION_PLACES;
    self->sealed.places_ticks[self->sealed.place] = view->position_ticks;
    self->sealed.lowest_ticks = view->position_ticks;
    self->sealed.highest_ticks = view->position_ticks;
    for (uint32_t i = 0U; i < SUPERVISION_PLACES; i++) {
        const int32_t place = self->sealed.places_ticks[i];
        self->sealed.lowest_ticks =
            (place < self->sealed.lowest_ticks) ? place : self->sealed.lowest_ticks;
        self->sealed.highest_ticks =
            (place > self->sealed.highest_ticks) ? place : self->sealed.highest_ticks;
    }
}

/* From the place of the last second that is farthest from here. */
static int32_t way_while_off(const supervision_t *self, const supervision_view_t *view)
{
    const int64_t up = (int64_t)view->position_ticks - (int64_t)self->sealed.lowest_ticks;
    const int64_t down = (int64_t)self->sealed.highest_ticks - (int64_t)view->position_ticks;
    return fixed_saturate((up > down) ? up : down);
}

static bool is_moving_while_off(supervision_t *self, const axis_config_t *config,
                                const supervision_view_t *view)
{
    const bool is_off = view->is_relied_on && (view->drive.mode == (uint32_t)CARD_DRIVE_OFF);
    const uint32_t more_us = is_off ? view->elapsed_us : 0U;
    self->sealed.off_us = is_off ? self->sealed.off_us : 0U;
    self->sealed.off_us += (self->sealed.off_us < MOTOR_REST_US) ? more_us : 0U;
    if (self->sealed.off_us < MOTOR_REST_US) {
        settle(self, view);
        return false;
    }
    remember_place(self, view);
    self->sealed.off_ticks = way_while_off(self, view);
    return (self->sealed.off_ticks != 0) &&
           joints_is_beyond(config, self->sealed.off_ticks, LIMIT_REST_WAY_NM,
                            LIMIT_REST_WAY_BAM) &&
           joints_is_above(config, self->sealed.off_ticks, LIMIT_REST_FLOOR_TICKS);
}

static uint32_t note(bool is_found, uint32_t name)
{
    return is_found ? name : 0U;
}

void supervision_init(supervision_t *self)
{
    (void)memset(self, 0, sizeof *self);
    stall_watchdog_chart_init(&self->stall);
    count_balance_init(&self->sealed.account);
    edge_spacing_init(&self->sealed.pace);
}

bool supervision_is_at_rest(const supervision_t *self)
{
    return self->sealed.off_us >= MOTOR_REST_US;
}

void supervision_reset(supervision_t *self, bool is_trusted)
{
    (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_RESET);
    if (!is_trusted) {
        supervision_settle(self);
    }
}

static int32_t shifted(int32_t place_ticks, int32_t ticks)
{
    return fixed_saturate((int64_t)place_ticks + (int64_t)ticks);
}

void supervision_shift(supervision_t *self, int32_t ticks)
{
    self->sealed.mark_ticks = shifted(self->sealed.mark_ticks, ticks);
    self->sealed.position_ticks = shifted(self->sealed.position_ticks, ticks);
    for (uint32_t i = 0U; i < SUPERVISION_PLACES; i++) {
        self->sealed.places_ticks[i] = shifted(self->sealed.places_ticks[i], ticks);
    }
    self->sealed.lowest_ticks = shifted(self->sealed.lowest_ticks, ticks);
    self->sealed.highest_ticks = shifted(self->sealed.highest_ticks, ticks);
}

/* Compares the way that the motor made with its drive with the counts. */
static uint32_t watch_motor(supervision_t *self, const axis_config_t *config,
                            const supervision_view_t *view)
{
    const uint32_t driven_us =
        (view->elapsed_us < LIMIT_CARD_WATCHDOG_US) ? view->elapsed_us : LIMIT_CARD_WATCHDOG_US;
    const int64_t before_q8 =
        motor_heat_slow(view->lost_q16, self->sealed.model.speed_ticks_per_s_q8);
    const int64_t way_q16 =
        motor_model_step_q16(&self->sealed.model, config, &view->drive, driven_us);
    count_cycle_t cycle = {
        .model_q16 = motor_heat_slow(view->lost_q16, way_q16),
        .counted_ticks = (int64_t)view->position_ticks - (int64_t)self->sealed.position_ticks,
        .due_q16 = 0U,
        .elapsed_us = driven_us,
    };
    const uint32_t uneven = note(is_uneven(self, view, before_q8, &cycle), AXIS_NOTE_UNEVEN_COUNTS);
    cycle.due_q16 = (cycle.model_q16 != 0) ? self->sealed.pace.ended_q16 : 0U;
    const uint32_t notes = watch_counts(self, config, &cycle) | uneven;
    if (uneven != 0U) {
        supervision_settle(self);
    }
    self->sealed.position_ticks = view->position_ticks;
    return notes;
}

static uint32_t drive_of(const axis_config_t *config, const card_drive_t *drive)
{
    if (drive->mode == (uint32_t)CARD_DRIVE_OFF) {
        return DRIVE_OFF;
    }
    return motor_model_is_upwards(config, drive) ? DRIVE_UP : DRIVE_DOWN;
}

/* By the motor as it runs. */
static uint32_t drive_before(const motor_model_t *model)
{
    if (model->speed_ticks_per_s_q8 == 0) {
        return DRIVE_OFF;
    }
    return (model->speed_ticks_per_s_q8 > 0) ? DRIVE_UP : DRIVE_DOWN;
}

static void miss_report(supervision_t *self, const axis_config_t *config,
                        const supervision_view_t *view)
{
    const uint32_t drives = drive_before(&self->sealed.model) | drive_of(config, &view->drive);
    self->sealed.drives = (uint16_t)(self->sealed.drives | drives);
}

/* Reports were missed, and not all of that time had the same drive. */
static bool is_history_unknown(const supervision_t *self, const axis_config_t *config,
                               const supervision_view_t *view)
{
    return (self->sealed.drives != 0U) && (self->sealed.drives != drive_of(config, &view->drive));
}

/* A cycle that makes good for a late one ends at once: whether a motor stops or turns meanwhile is
 * unknown, and the clock of a card that counts longer parts of time did not go on. */
static bool is_change_too_brief(const supervision_t *self, const axis_config_t *config,
                                const supervision_view_t *view)
{
    const uint32_t before = drive_before(&self->sealed.model);
    return (view->elapsed_us < LIMIT_BRIEF_DRIVE_US) && (before != DRIVE_OFF) &&
           (before != drive_of(config, &view->drive));
}

/* The motor runs on from here, whatever it did meanwhile. */
static void pass_over(supervision_t *self, const axis_config_t *config,
                      const supervision_view_t *view)
{
    (void)motor_model_step_q16(&self->sealed.model, config, &view->drive, LIMIT_CARD_WATCHDOG_US);
    self->sealed.position_ticks = view->position_ticks;
    self->sealed.mark_ticks = view->position_ticks;
    self->sealed.off_us = 0U;
    self->sealed.drives = 0U;
    settle(self, view);
    count_balance_doubt(&self->sealed.account);
    edge_spacing_begin(&self->sealed.pace);
}

uint32_t supervision_step(supervision_t *self, const axis_config_t *config,
                          const supervision_view_t *view)
{
    if (self->sealed.rest_ticks == 0) {
        self->sealed.rest_ticks = supervision_rest_ticks(config);
    }
    uint32_t notes = note(is_stalled(self, config, view), AXIS_NOTE_STALLED);
    if (view->elapsed_us == 0U) {
        miss_report(self, config, view);
        return notes;
    }
    notes |= note(is_astray(view), AXIS_NOTE_FOLLOWING_ERROR);
    if (is_history_unknown(self, config, view) || is_change_too_brief(self, config, view)) {
        pass_over(self, config, view);
        return notes;
    }
    self->sealed.drives = 0U;
    notes |= note(is_backwards(self, view), AXIS_NOTE_WRONG_WAY);
    notes |= note(is_moving_while_off(self, config, view), AXIS_NOTE_MOVED_OFF);
    return notes | watch_motor(self, config, view);
}
