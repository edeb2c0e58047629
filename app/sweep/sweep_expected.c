/* SPDX-License-Identifier: Apache-2.0 */
#include "sweep/sweep_expected.h"

#include "motion/motor_model.h"
#include "sweep/sweep_curve.h"

#define WORDS_PER_HZ 22009
#define RUN_S ((double)LIMIT_SWEEP_RUN_MS / 1000.0)

bool sweep_expected(const axis_config_t *axis, int32_t hertz, double *turns_per_min)
{
    const card_drive_t drive = {.mode = (uint32_t)CARD_DRIVE_HIGH_FREQUENCY,
                                .duty = (uint32_t)hertz * WORDS_PER_HZ,
                                .amplitude = axis->amplitude};
    const int64_t speed_q8 = motor_model_steady_q8(axis, &drive);
    *turns_per_min = sweep_curve_turns_per_min(axis, (int32_t)((double)speed_q8 / 256.0 * RUN_S));
    return speed_q8 != 0;
}
