/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/motor_heat.h"

#include "limits/requirement_limits.h"

#define WORDS_PER_HZ 22009U

/* Loss of speed for each kelvin, by motor_type_t. */
static const uint8_t loss_permille[] = {LIMIT_SHINSEI_SPEED_LOSS_PERMILLE,
                                        LIMIT_PIEZO_SPEED_LOSS_PERMILLE,
                                        LIMIT_DTI_SPEED_LOSS_PERMILLE};

motor_heat_t motor_heat_of(const axis_config_t *config, int32_t heat_dc)
{
    const int32_t hottest_dc = (heat_dc < config->hottest_dc) ? heat_dc : config->hottest_dc;
    motor_heat_t heat = {0U, 0U};
    if (hottest_dc > (int32_t)LIMIT_MOTOR_TABLE_DC) {
        const uint32_t above_dk = (uint32_t)hottest_dc - LIMIT_MOTOR_TABLE_DC;
        const uint32_t loss = loss_permille[config->motor_type];
        heat.lost_q16 = (uint16_t)((above_dk * loss * 65536U) / 10000U);
        heat.shift_hz = (uint16_t)((above_dk * config->resonance_hz_per_k) / 10U);
    }
    return heat;
}

void motor_heat_lower(const motor_heat_t *self, card_drive_t *drive)
{
    const uint32_t shift = (uint32_t)self->shift_hz * WORDS_PER_HZ;
    const uint32_t most = drive->duty - LIMIT_RESONANCE_WORD;
    drive->duty -= (shift < most) ? shift : most;
}

void motor_heat_raise(const motor_heat_t *self, card_drive_t *drive)
{
    drive->duty += (uint32_t)self->shift_hz * WORDS_PER_HZ;
}
