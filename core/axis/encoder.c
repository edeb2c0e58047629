/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/encoder.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

#include <stddef.h>
#include <string.h>

/* Facts of the estimator (M/T): shorter spans are dominated by the time stamps; over whole cycles
 * of the four states their unequal widths cancel. */
#define SPEED_SPAN_US 6000U
#define CYCLE_TICKS 4
#define Q8_US_PER_S INT64_C(256000000)

/* Difference of two counters that wrap. */
static int32_t wrapped_difference(int32_t to, int32_t from)
{
    const uint32_t difference = (uint32_t)to - (uint32_t)from;
    int64_t signed_difference = (int64_t)difference;
    if (difference > (uint32_t)INT32_MAX) {
        signed_difference -= INT64_C(4294967296);
    }
    return (int32_t)signed_difference;
}

static void anchor(encoder_t *self, const card_report_t *report)
{
    self->anchor_ticks = self->position_ticks;
    self->anchor_us = report->last_edge_us;
}

static void measure(encoder_t *self, const card_report_t *report, int32_t speed_ticks_per_s_q8)
{
    self->measured_ticks_per_s_q8 = speed_ticks_per_s_q8;
    self->speed_ticks_per_s_q8 = speed_ticks_per_s_q8;
    anchor(self, report);
}

/* The speed measured last, but no more than `ticks` in `time_us`. */
static void limit_speed(encoder_t *self, int64_t ticks, uint32_t time_us)
{
    const int64_t measured_q8 = (int64_t)self->measured_ticks_per_s_q8;
    const int64_t most_q8 = fixed_divide_signed(ticks * Q8_US_PER_S, (int64_t)time_us);
    const int64_t size_q8 =
        (fixed_magnitude(measured_q8) > most_q8) ? most_q8 : fixed_magnitude(measured_q8);
    self->speed_ticks_per_s_q8 = (int32_t)((measured_q8 < 0) ? -size_q8 : size_q8);
}

/* A tick that is long overdue: the speed is at most that of a tick just now. Once it has come, the
 * ticks since the measurement say how fast the axis may be: in bursts the next ones come early. */
static void wait_for_ticks(encoder_t *self, uint32_t quiet_us, uint32_t span_us, int64_t travelled)
{
    const int64_t size_q8 = fixed_magnitude((int64_t)self->measured_ticks_per_s_q8);
    const int64_t wait_q8_us = (Q8_US_PER_S / 100) * (int64_t)LIMIT_SPEED_WAIT_PERCENT;
    if ((size_q8 * (int64_t)quiet_us) > wait_q8_us) {
        limit_speed(self, 1, quiet_us);
    } else if ((self->speed_ticks_per_s_q8 != self->measured_ticks_per_s_q8) && (span_us > 0U)) {
        limit_speed(self, fixed_magnitude(travelled) + 1, span_us);
    } else {
        /* Nothing was or is overdue. */
    }
}

static void estimate_speed(encoder_t *self, const card_report_t *report)
{
    const uint32_t span_us = report->last_edge_us - self->anchor_us;
    const uint32_t quiet_us = report->time_us - report->last_edge_us;
    const int64_t travelled = (int64_t)self->position_ticks - (int64_t)self->anchor_ticks;
    if (quiet_us >= LIMIT_SPEED_TIMEOUT_US) {
        self->is_at_rest = 1U;
        measure(self, report, 0);
    } else if (self->is_at_rest != 0U) {
        /* The first edge: how long it rested says nothing of how fast it is now. */
        self->is_at_rest = 0U;
        anchor(self, report);
    } else if ((span_us >= SPEED_SPAN_US) && ((travelled % CYCLE_TICKS) == 0)) {
        measure(self, report,
                fixed_saturate(fixed_divide_rounded(travelled * Q8_US_PER_S, (int64_t)span_us)));
    } else {
        wait_for_ticks(self, quiet_us, span_us, travelled);
    }
}

void encoder_init(encoder_t *self)
{
    (void)memset(self, 0, sizeof *self);
}

static bool is_believable(const encoder_t *self, const axis_config_t *config, int32_t change_ticks)
{
    const int64_t cycles = (int64_t)self->missed_cycles + 1;
    const int64_t most = (int64_t)config->jump_ticks * cycles;
    return ((int64_t)change_ticks <= most) && ((int64_t)change_ticks >= -most);
}

int32_t encoder_way(const axis_config_t *config, int32_t from_reading, int32_t to_reading)
{
    return (config->is_encoder_inverted != 0U) ? wrapped_difference(from_reading, to_reading)
                                               : wrapped_difference(to_reading, from_reading);
}

bool encoder_step(encoder_t *self, const axis_config_t *config, const card_report_t *report)
{
    if (report == NULL) {
        self->missed_cycles += (self->missed_cycles < UINT32_MAX) ? 1U : 0U;
        return false;
    }
    if (self->has_reading == 0U) {
        self->has_reading = 1U;
        self->reading = report->encoder_count;
        anchor(self, report);
        return false;
    }
    const int32_t change_ticks = wrapped_difference(report->encoder_count, self->reading);
    if (!is_believable(self, config, change_ticks)) {
        self->jump_ticks = change_ticks;
        self->jumps++;
        if (self->jumps < 2U) {
            return false;
        }
        self->jumps = 0U;
        self->missed_cycles = 0U;
        self->reading = report->encoder_count;
        anchor(self, report);
        return true;
    }
    self->jumps = 0U;
    self->missed_cycles = 0U;
    self->edge_age_us = (report->edges == CARD_EDGES_UNKNOWN)
                            ? ENCODER_AGE_UNKNOWN
                            : (report->time_us - report->last_edge_us);
    if (change_ticks != 0) {
        const int64_t moved_ticks =
            (int64_t)encoder_way(config, self->reading, report->encoder_count);
        self->reading = report->encoder_count;
        self->position_ticks = fixed_saturate((int64_t)self->position_ticks + moved_ticks);
    }
    estimate_speed(self, report);
    return false;
}

bool encoder_is_at_rest(const encoder_t *self)
{
    return self->is_at_rest != 0U;
}

void encoder_set_position(encoder_t *self, int32_t position_ticks)
{
    const int64_t shift = (int64_t)position_ticks - (int64_t)self->position_ticks;
    self->anchor_ticks = fixed_saturate((int64_t)self->anchor_ticks + shift);
    self->position_ticks = position_ticks;
}
