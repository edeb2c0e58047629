/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/homing.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

#define CYCLES_PER_S (INT32_C(1000000) / (int32_t)LIMIT_CYCLE_US)
/* Free for so far, the switch has released. */
#define CLEAR_TICKS INT64_C(3)

/* Both edges are late by the debouncing, up to 10 ms, at different speeds. */
static int64_t edge_spread_ticks(const axis_config_t *config)
{
    return ((int64_t)config->home_speed_ticks_per_s / 100) + 2;
}

static bool is_leaving(axis_reference_t leg)
{
    return (leg == AXIS_REFERENCE_LEAVE) || (leg == AXIS_REFERENCE_BACK_OFF);
}

void homing_begin(homing_t *self, int32_t position_ticks)
{
    self->start_ticks = position_ticks;
    self->leg_us = 0U;
    if (self->has_nearest == 0U) {
        self->has_nearest = 1U;
        self->nearest_ticks = position_ticks;
    }
}

void homing_renew(homing_t *self)
{
    self->leg_us = 0U;
}

void homing_meet(homing_t *self, const axis_config_t *config, int32_t free_ticks)
{
    const int64_t way = fixed_magnitude(homing_way(config, self->edge_ticks, free_ticks));
    self->edge_ticks = (way <= edge_spread_ticks(config)) ? free_ticks : self->edge_ticks;
}

void homing_forget(homing_t *self)
{
    self->has_nearest = 0U;
}

/* Backing off goes as far as a sound switch may hold on, so that one that flickers is seen to. */
static bool is_clear(const homing_t *self, const axis_config_t *config, axis_reference_t leg,
                     int32_t position_ticks)
{
    const int64_t held =
        (leg == AXIS_REFERENCE_BACK_OFF) ? (int64_t)config->switch_hysteresis_ticks : INT64_C(0);
    return (homing_way(config, self->switch_ticks, position_ticks) >= CLEAR_TICKS) &&
           (homing_way(config, self->edge_ticks, position_ticks) >= (held + CLEAR_TICKS));
}

static homing_sight_t see_active(homing_t *self, const axis_config_t *config, axis_reference_t leg,
                                 int32_t position_ticks)
{
    self->switch_ticks = position_ticks;
    if ((leg == AXIS_REFERENCE_LATCH) &&
        (homing_way(config, self->edge_ticks, position_ticks) > edge_spread_ticks(config))) {
        return HOMING_WRONG;
    }
    if (leg != AXIS_REFERENCE_BACK_OFF) {
        self->edge_ticks = position_ticks;
    }
    return HOMING_SWITCH;
}

homing_sight_t homing_see(homing_t *self, const axis_config_t *config, axis_reference_t leg,
                          int32_t position_ticks, bool is_switch_active)
{
    if (homing_is_leg(leg) && (homing_way(config, self->nearest_ticks, position_ticks) < 0)) {
        self->nearest_ticks = position_ticks;
    }
    if (is_switch_active) {
        return see_active(self, config, leg, position_ticks);
    }
    return is_clear(self, config, leg, position_ticks) ? HOMING_CLEAR : HOMING_NOTHING;
}

/* Its other stop lies a little beyond the soft limit. */
static int64_t longest_approach_ticks(const axis_config_t *config)
{
    const int64_t soft = (int64_t)config->maximum_ticks - (int64_t)config->minimum_ticks;
    return soft + (soft / 32) + (int64_t)config->home_way_ticks;
}

bool homing_is_too_far(const homing_t *self, const axis_config_t *config, axis_reference_t leg,
                       int32_t position_ticks)
{
    bool is_far = false;
    if (is_leaving(leg)) {
        is_far = homing_way(config, self->nearest_ticks, position_ticks) >
                 (int64_t)config->home_way_ticks;
    } else if (leg == AXIS_REFERENCE_APPROACH) {
        is_far =
            homing_way(config, position_ticks, self->start_ticks) > longest_approach_ticks(config);
    } else {
        is_far = homing_way(config, position_ticks, self->edge_ticks) > edge_spread_ticks(config);
    }
    return is_far;
}

static int32_t part_of(int32_t speed_q8, uint32_t percent)
{
    return (int32_t)fixed_divide_by((int64_t)speed_q8 * (int64_t)percent, 100U);
}

/* Speed wanted in a leg, signed. */
static int32_t speed_wanted_q8(const axis_config_t *config, axis_reference_t leg)
{
    int32_t speed_q8 = 256 * config->home_speed_ticks_per_s;
    if (config->limit_switch != (uint8_t)LIMIT_SWITCH_UPPER) {
        speed_q8 = -speed_q8;
    }
    if (is_leaving(leg)) {
        speed_q8 = part_of(-speed_q8, LIMIT_HOME_LEAVE_PERCENT);
    } else if (leg == AXIS_REFERENCE_LATCH) {
        speed_q8 = part_of(speed_q8, LIMIT_HOME_LATCH_PERCENT);
    } else {
        /* Fast approach. */
    }
    return speed_q8;
}

static int32_t ramp_towards(int32_t speed_q8, int32_t wanted_q8, int32_t step_q8)
{
    int32_t next_q8 = wanted_q8;
    if ((wanted_q8 - speed_q8) > step_q8) {
        next_q8 = speed_q8 + step_q8;
    } else if ((speed_q8 - wanted_q8) > step_q8) {
        next_q8 = speed_q8 - step_q8;
    } else {
        /* The wanted speed is within one step. */
    }
    return next_q8;
}

void homing_step(homing_t *self, const axis_config_t *config, axis_reference_t leg,
                 int32_t position_ticks)
{
    if (self->ramp != (uint32_t)leg) {
        self->ramp = (uint32_t)leg;
        self->setpoint_q8 = (int64_t)position_ticks * 256;
        self->speed_ticks_per_s_q8 = 0;
    }
    /* 256 / CYCLES_PER_S in lowest terms by 4: the most acceleration times 64 fits 32 bits. */
    const int32_t step_q8 = (config->acceleration_ticks_per_s2 * 64) / (CYCLES_PER_S / 4);
    self->speed_ticks_per_s_q8 =
        ramp_towards(self->speed_ticks_per_s_q8, speed_wanted_q8(config, leg), step_q8);
    self->setpoint_q8 += (int64_t)self->speed_ticks_per_s_q8 / CYCLES_PER_S;
}

void homing_rest(homing_t *self)
{
    self->ramp = (uint32_t)AXIS_REFERENCE_FRESH;
}
