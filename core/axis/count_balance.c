/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/count_balance.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "motion/motor_model.h"
#include "robot/joints.h"

#include <string.h>

#define ONE_E2_Q16 INT64_C(6553600)
#define WINDOW_Q16 ((int64_t)LIMIT_ACCOUNT_WINDOW_TICKS * 65536)
/* In fewer ticks one more or less would say too much of a motor. */
#define CALIBRATION_Q16 (3 * WINDOW_Q16)

/* All in percent. */
typedef struct {
    uint32_t least; /* Share of the model's way, in a window. */
    uint32_t most;
    uint32_t shown_least; /* The same in the time of calibration. */
    uint32_t shown_most;
    uint32_t kept; /* Share of the speed shown then, in a window. */
    uint32_t more;
} regime_facts_t;

static const regime_facts_t regimes[COUNT_REGIMES] = {
    {LIMIT_RISING_LEAST_PERCENT, LIMIT_RISING_MOST_PERCENT, LIMIT_RISING_SHOWN_LEAST_PERCENT,
     LIMIT_RISING_SHOWN_MOST_PERCENT, LIMIT_RISING_KEPT_PERCENT, LIMIT_RISING_MORE_PERCENT},
    {LIMIT_SPEED_LEAST_PERCENT, LIMIT_SPEED_MOST_PERCENT, LIMIT_SPEED_SHOWN_LEAST_PERCENT,
     LIMIT_SPEED_SHOWN_MOST_PERCENT, LIMIT_SPEED_KEPT_PERCENT, LIMIT_SPEED_MORE_PERCENT}};

void count_balance_init(count_balance_t *self)
{
    (void)memset(self, 0, sizeof *self);
    for (uint32_t i = 0U; i < (uint32_t)COUNT_REGIMES; i++) {
        self->calibrations[i].least_percent = regimes[i].least;
        self->calibrations[i].most_percent = regimes[i].most;
    }
}

static void clear_window(count_balance_t *self)
{
    self->window_us = 0U;
    self->model_q16 = 0;
    self->least_e2_q16 = 0;
    self->most_e2_q16 = 0;
    self->counted_ticks = 0;
}

void count_balance_settle(count_balance_t *self)
{
    clear_window(self);
    self->short_e2_q16 = 0;
    self->over_e2_q16 = 0;
}

void count_balance_doubt(count_balance_t *self)
{
    clear_window(self);
    self->has_count = 0U;
    self->unsure_us = LIMIT_RISING_TIME_US;
}

/* A motor that is off has no speed to be unsure of. */
static void grow_sure(count_balance_t *self, const count_cycle_t *cycle)
{
    const bool is_sure = (cycle->model_q16 == 0) || (self->unsure_us < cycle->elapsed_us);
    self->unsure_us -= is_sure ? self->unsure_us : cycle->elapsed_us;
}

/* Longer than a pause or a run is, a time needs not be known. */
static uint32_t longer(uint32_t time_us, uint32_t elapsed_us)
{
    const uint32_t more_us = (time_us < LIMIT_RISING_TIME_US) ? elapsed_us : 0U;
    return time_us + more_us;
}

static void follow_drive(count_balance_t *self, int64_t model_q16, uint32_t elapsed_us)
{
    int32_t direction = 1;
    if (model_q16 == 0) {
        self->run_us = 0U;
        self->rest_us = longer(self->rest_us, elapsed_us);
        return;
    }
    if (model_q16 < 0) {
        direction = -1;
    }
    self->run_us = (direction == self->direction) ? longer(self->run_us, elapsed_us) : 0U;
    self->rest_us = 0U;
    self->direction = direction;
    self->regime = (uint16_t)((self->run_us < LIMIT_RISING_TIME_US) ? COUNT_REGIME_RISING
                                                                    : COUNT_REGIME_STEADY);
    self->has_count = (self->regime == (uint16_t)COUNT_REGIME_STEADY) ? self->has_count : 0U;
}

static bool is_calibrated(const count_calibration_t *shown)
{
    return (shown->time_us >= LIMIT_CALIBRATION_TIME_US) && (shown->model_q16 >= CALIBRATION_Q16);
}

static void clear_calibration(count_calibration_t *shown)
{
    shown->model_q16 = 0;
    shown->counted_ticks = 0;
    shown->time_us = 0U;
}

/* A motor that has shown for a while how fast it is must stay so. A speed that no motor of the
 * table shows is a fault, and nothing to go by. */
static bool narrow(count_calibration_t *shown, const regime_facts_t *facts)
{
    const int32_t counted =
        fixed_saturate(((int64_t)shown->counted_ticks * ONE_E2_Q16) / shown->model_q16);
    const uint32_t percent = (counted < 0) ? 0U : (uint32_t)counted;
    const uint32_t kept = (percent * facts->kept) / 100U;
    const uint32_t more = (percent * facts->more) / 100U;
    if ((percent < facts->shown_least) || (percent > facts->shown_most)) {
        clear_calibration(shown);
        return false;
    }
    shown->least_percent = (kept > shown->least_percent) ? kept : shown->least_percent;
    shown->most_percent = (more < shown->most_percent) ? more : shown->most_percent;
    return true;
}

static void add(count_calibration_t *shown, uint32_t way_q16, int32_t counted_ticks)
{
    shown->model_q16 += (int64_t)way_q16;
    shown->counted_ticks = fixed_saturate((int64_t)shown->counted_ticks + (int64_t)counted_ticks);
}

/* Steadily from one count to the next: short runs that end with a count, or just before one, would
 * have a part of a tick too much each, or too little. */
static void show_steady(count_balance_t *self, count_calibration_t *shown, uint32_t due_q16,
                        int32_t counted_ticks)
{
    if (due_q16 == 0U) {
        return;
    }
    if (self->has_count != 0U) {
        add(shown, due_q16, counted_ticks);
    }
    self->has_count = 1U;
}

static bool calibrate(count_balance_t *self, uint32_t way_q16, int32_t counted_ticks,
                      const count_cycle_t *cycle)
{
    count_calibration_t *const shown = &self->calibrations[self->regime];
    if (is_calibrated(shown)) {
        return true;
    }
    shown->time_us += (way_q16 != 0U) ? cycle->elapsed_us : 0U;
    if (self->regime == (uint16_t)COUNT_REGIME_STEADY) {
        show_steady(self, shown, cycle->due_q16, counted_ticks);
    } else {
        add(shown, way_q16, counted_ticks);
    }
    return !is_calibrated(shown) || narrow(shown, &regimes[self->regime]);
}

/* A shortfall counts in full, a surplus gives back only a part: a fault that comes and goes is not
 * made good by the time between. */
static int64_t summed(int64_t sum_e2_q16, int64_t missing_e2_q16)
{
    const int64_t more_e2_q16 =
        (missing_e2_q16 > 0) ? missing_e2_q16 : (missing_e2_q16 / (int64_t)LIMIT_ACCOUNT_GIVE_BACK);
    const int64_t next_e2_q16 = sum_e2_q16 + more_e2_q16;
    return (next_e2_q16 > 0) ? next_e2_q16 : 0;
}

static void close_window(count_balance_t *self)
{
    const int64_t counted_e2_q16 = (int64_t)self->counted_ticks * ONE_E2_Q16;
    self->short_e2_q16 = summed(self->short_e2_q16, self->least_e2_q16 - counted_e2_q16);
    self->over_e2_q16 = summed(self->over_e2_q16, counted_e2_q16 - self->most_e2_q16);
    self->percent = fixed_saturate(counted_e2_q16 / self->model_q16);
    clear_window(self);
}

/* A window ends with a count, so that a part of a tick is not taken for a missing one; at twice its
 * way it ends without. */
static bool is_window_full(const count_balance_t *self, int32_t counted_ticks)
{
    const bool is_long =
        (self->model_q16 >= WINDOW_Q16) && (self->window_us >= LIMIT_ACCOUNT_WINDOW_US);
    return is_long && ((counted_ticks > 0) || (self->model_q16 >= (2 * WINDOW_Q16)));
}

static bool is_beyond(const axis_config_t *config, int64_t sum_e2_q16)
{
    const int64_t ticks = sum_e2_q16 / ONE_E2_Q16;
    return (ticks >= (int64_t)LIMIT_ACCOUNT_TICKS) &&
           joints_is_beyond(config, ticks, LIMIT_REST_WAY_NM, LIMIT_REST_WAY_BAM);
}

bool count_balance_step(count_balance_t *self, const axis_config_t *config,
                        const count_cycle_t *cycle)
{
    const int64_t model_q16 = cycle->model_q16;
    follow_drive(self, model_q16, cycle->elapsed_us);
    /* Until the motor rests, counts are of its last drive. */
    if (self->unsure_us != 0U) {
        grow_sure(self, cycle);
        return false;
    }
    if (self->rest_us > MOTOR_REST_US) {
        return false;
    }
    const count_calibration_t *const shown = &self->calibrations[self->regime];
    const int64_t way_q16 = (model_q16 < 0) ? -model_q16 : model_q16;
    const int32_t counted = fixed_saturate(cycle->counted_ticks * (int64_t)self->direction);
    self->window_us += (way_q16 != 0) ? cycle->elapsed_us : 0U;
    self->model_q16 += way_q16;
    self->counted_ticks = fixed_saturate((int64_t)self->counted_ticks + (int64_t)counted);
    self->least_e2_q16 += way_q16 * (int64_t)shown->least_percent;
    self->most_e2_q16 += way_q16 * (int64_t)shown->most_percent;
    if (!calibrate(self, (uint32_t)way_q16, counted, cycle)) {
        return true;
    }
    if (!is_window_full(self, counted)) {
        return false;
    }
    close_window(self);
    return is_beyond(config, self->short_e2_q16) || is_beyond(config, self->over_e2_q16);
}
