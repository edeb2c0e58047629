/* SPDX-License-Identifier: Apache-2.0 */
/** @file One axis that a test observes, drives and supervises cycle by cycle. */
#ifndef BORESIGHT_AXIS_WORLD_H
#define BORESIGHT_AXIS_WORLD_H

#include "axis/axis.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include <string.h>

#define CYCLE_US 1000U
#define STALL_CYCLES (LIMIT_STALL_TIME_US / CYCLE_US)
#define PROGRESS ((int32_t)LIMIT_STALL_PROGRESS_TICKS)
#define WRONG_WAY ((int32_t)LIMIT_WRONG_WAY_TICKS)
#define ABOVE 100
#define BELOW (-100)

static const axis_config_t *const with_upper_switch = &robot_neuro.axes[NEURO_AXIS_PITCH];
static const axis_config_t *const inverted = &robot_neuro.axes[NEURO_AXIS_HEAD];
static const axis_config_t *const with_lower_switch = &robot_neuro.axes[NEURO_AXIS_INSERTION];
static const axis_config_t *const without_switch = &robot_neuro.axes[NEURO_AXIS_ROTATION];

static axis_t axis;
static const axis_config_t *config;
static card_report_t report;
static int32_t setpoint_ticks;

/* The card says that the axis has moved by `ticks`. */
static inline uint32_t observe_way(int32_t ticks)
{
    report.time_us += CYCLE_US;
    if (ticks != 0) {
        report.last_edge_us = report.time_us;
    }
    report.encoder_count += (config->is_encoder_inverted != 0U) ? -ticks : ticks;
    return axis_observe(&axis, config, &report, CYCLE_US);
}

static inline uint32_t observe_switch(bool is_active)
{
    const uint32_t bit =
        (config->limit_switch == LIMIT_SWITCH_LOWER) ? CARD_LIMIT_LOWER : CARD_LIMIT_UPPER;

    report.limits = is_active ? bit : 0U;
    return observe_way(0);
}

static inline void move_to(int32_t position_ticks)
{
    while (axis.sealed.encoder.position_ticks != position_ticks) {
        const int32_t way = position_ticks - axis.sealed.encoder.position_ticks;
        const int32_t most = config->jump_ticks;
        TEST_ASSERT_EQUAL_HEX32(0U,
                                observe_way((way > most) ? most : ((way < -most) ? -most : way)));
    }
}

/* An axis that is enabled and stands at 0. */
static inline void use(const axis_config_t *which)
{
    config = which;
    (void)memset(&report, 0, sizeof report);
    axis_init(&axis);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_observe(&axis, config, &report, CYCLE_US));
    axis_enable(&axis, false);
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
    setpoint_ticks = 0;
}

/* While driven, the motor gets pulses that are too short to move it. */
static inline uint32_t supervise(bool is_driven, uint32_t elapsed_us)
{
    static uint32_t cycle = 0U;
    cycle++;
    const bool is_pulse = is_driven && (elapsed_us == CYCLE_US) && ((cycle % 8U) == 0U);
    const card_drive_t sent = {.mode = is_pulse ? CARD_DRIVE_NON_PWM : CARD_DRIVE_OFF,
                               .direction = (cycle / 8U) % 2U};
    const axis_sample_t sample = {.applied = &sent, .elapsed_us = elapsed_us, .is_timed = true};
    return axis_supervise(&axis, config, is_driven, &sample);
}

/* One cycle in which the motor was driven towards the set-point and moved by `ticks`. */
static inline uint32_t driven_cycle(int32_t ticks)
{
    (void)axis_follow(&axis, config, setpoint_ticks, 0, CYCLE_US);
    return observe_way(ticks) | supervise(true, CYCLE_US);
}

/* Notes of `cycles` driven cycles without any movement. */
static inline uint32_t push(uint32_t cycles)
{
    uint32_t notes = 0U;

    for (uint32_t i = 0U; i < cycles; i++) {
        notes |= driven_cycle(0);
    }
    return notes;
}

static inline void begin_homing(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_TRUE(axis_is_homing(&axis));
}

/* No edge for so long. */
static inline void stand_still(uint32_t us)
{
    report.time_us += us - CYCLE_US;
    TEST_ASSERT_EQUAL_HEX32(0U, observe_way(0));
}

static inline void home_in_place(void)
{
    stand_still(LIMIT_SPEED_TIMEOUT_US);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, axis_begin_homing(&axis, config));
    TEST_ASSERT_TRUE(axis_is_homed(&axis));
}

static inline axis_reference_t reference(void)
{
    return axis.chart.reference;
}

#endif
