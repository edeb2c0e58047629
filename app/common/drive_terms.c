/* SPDX-License-Identifier: Apache-2.0 */
#include "common/drive_terms.h"

#include "motion/motor_model.h"
#include "motion/servo.h"

double drive_terms_percent(const axis_config_t *config, const snapshot_axis_t *axis)
{
    const card_drive_t drive = {axis->drive_mode, axis->drive_direction, axis->drive_duty, 0U};
    double percent = 100.0;

    if (drive.mode == (uint32_t)CARD_DRIVE_OFF) {
        return 0.0;
    }
    if (config->card_type == (uint8_t)CARD_TYPE_HIGH_FREQUENCY) {
        /* Its word falls as the speed grows. */
        percent = (100.0 * (double)motor_model_steady_q8(config, &drive)) /
                  (256.0 * (double)config->full_speed_ticks_per_s);
    } else if (motor_model_has_magnitudes(config)) {
        percent = (100.0 * (double)drive.duty) / (double)config->maximum_duty;
    } else {
        /* It runs. */
    }
    return motor_model_is_upwards(config, &drive) ? percent : -percent;
}
