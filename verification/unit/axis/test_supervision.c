/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the noise of a scanner on the encoder lines of an axis at rest is no fault. */
#include "unity.h"

#include "axis/axis.h"
#include "axis/supervision.h"
#include "card/card_frame.h"
#include "robot/robot_neuro.h"
#include "sim/model/sim_encoder.h"
#include "sim/model/sim_motor.h"
#include "unit/support/scenes.h"

#include <string.h>

#define CYCLE_US 1000U
#define TEN_MINUTES_CYCLES 600000U

static axis_t axis;
static sim_encoder_t encoder;

void setUp(void)
{
}

void tearDown(void)
{
}

/* Notes of ten minutes of scanning with the axis homed and off. */
static uint32_t scan(const axis_config_t *config, uint32_t seed)
{
    const card_drive_t off = {.mode = CARD_DRIVE_OFF};
    const axis_sample_t sample = {.applied = &off, .elapsed_us = CYCLE_US, .is_timed = true};
    card_report_t report;
    uint32_t notes = 0U;

    (void)memset(&report, 0, sizeof report);
    sim_encoder_init(&encoder, config, 0.0, 0, seed);
    axis_init(&axis);
    axis_enable(&axis, false);
    for (uint32_t cycle = 0U; cycle < TEN_MINUTES_CYCLES; cycle++) {
        for (uint32_t us = 0U; us < CYCLE_US; us += SIM_STEP_US) {
            sim_encoder_step(&encoder, 0.0, 0.0, (cycle * CYCLE_US) + us, true);
        }
        report.time_us += CYCLE_US;
        report.encoder_count = sim_encoder_count(&encoder);
        notes |= axis_observe(&axis, config, &report, CYCLE_US);
        (void)axis_rest(&axis, CYCLE_US);
        notes |= axis_supervise(&axis, config, false, &sample);
    }
    return notes;
}

void test_SWR_AXIS_016_ten_minutes_of_scanning_are_no_motion(void)
{
    for (uint32_t seed = 1U; seed <= SCENES(3U); seed++) {
        TEST_ASSERT_EQUAL_HEX32(0U, scan(&robot_neuro.axes[NEURO_AXIS_LATERAL], seed));
        TEST_ASSERT_NOT_EQUAL_INT32(0, axis.sealed.encoder.position_ticks);
    }
}
