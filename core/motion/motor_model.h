/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Response of an ultrasonic motor to its drive words, as far as it is known without looking: it
 * runs at the speed of the word, gains it with one time constant, loses it with a shorter one, and
 * stops at once. The servo plans its last ticks with it; supervision compares it with what the
 * encoder counts.
 */
#ifndef BORESIGHT_MOTOR_MODEL_H
#define BORESIGHT_MOTOR_MODEL_H

#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** From an off word that is sent to a motor that surely rests: it may then be reversed. */
#define MOTOR_REST_US LIMIT_REVERSAL_DWELL_US

typedef struct {
    int64_t speed_ticks_per_s_q8;
} motor_model_t;

/** The drive of this axis has magnitudes, its `duty`: always but without pwm, where its table may
 * have them. Otherwise it is run or stop. */
static inline bool motor_model_has_magnitudes(const axis_config_t *config)
{
    return config->maximum_duty != 0U;
}

/** motor_model_step_q16() of a drive that is not off. */
int64_t motor_model_run_q16(motor_model_t *self, const axis_config_t *config,
                            const card_drive_t *drive, uint32_t elapsed_us);

/** `drive` was applied for `elapsed_us`. @return the way that it should have made, in ticks */
static inline int64_t motor_model_step_q16(motor_model_t *self, const axis_config_t *config,
                                           const card_drive_t *drive, uint32_t elapsed_us)
{
    if (drive->mode == (uint32_t)CARD_DRIVE_OFF) {
        self->speed_ticks_per_s_q8 = 0;
        return 0;
    }
    return motor_model_run_q16(self, config, drive, elapsed_us);
}

/**
 * The words of a high-frequency card fall as the speed grows, along the axis' curve.
 *
 * @return the magnitude at which a motor that has magnitudes settles to `speed_ticks_per_s_q8`, or
 * to the nearest speed that it has
 *
 * @satisfies SWR-DRIVE-005
 */
uint32_t motor_model_duty(const axis_config_t *config, int64_t speed_ticks_per_s_q8);

/**
 * @return the speed that `drive`, which is not off, settles to, without its sign, 0 to that of
 * full_speed_ticks_per_s for any word: full speed from maximum_duty on; 0 in the dead zone, below
 * minimum_duty, where the motor sticks; 0, unknown, for waves slower than the axis' slowest by more
 * than LIMIT_SWEEP_MARGIN_WORDS, which only a sweep drives with
 *
 * @satisfies SWR-SWEEP-009
 * @satisfies SWR-AXIS-019
 */
int64_t motor_model_steady_q8(const axis_config_t *config, const card_drive_t *drive);

/** True when `drive` makes the position grow. */
static inline bool motor_model_is_upwards(const axis_config_t *config, const card_drive_t *drive)
{
    return (drive->direction != 0U) != (config->is_motor_inverted != 0U);
}

#endif
