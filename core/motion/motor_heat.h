/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Effects on a motor that is warmer than that of its table: it is slower, and the waves that its
 * card makes must follow its resonance. Each axis owns one; servo and model know only words and
 * ways of a motor as its table has it.
 */
#ifndef BORESIGHT_MOTOR_HEAT_H
#define BORESIGHT_MOTOR_HEAT_H

#include "card/card_frame.h"
#include "robot/robot.h"

#include <stdint.h>

/** All zero: as the table has it. */
typedef struct {
    uint16_t lost_q16; /**< Share of its speed that it has lost, 16 fraction bits. */
    uint16_t shift_hz; /**< So much lower is its resonance; 0 without waves. */
} motor_heat_t;

/**
 * @param heat_dc what its card reports, 0.1 degree Celsius, any; counts between
 * LIMIT_MOTOR_TABLE_DC and the hottest that the axis' motor may be
 *
 * @satisfies SWR-DRIVE-015
 * @satisfies SWR-DRIVE-016
 */
motor_heat_t motor_heat_of(const axis_config_t *config, int32_t heat_dc);

/** Makes of the waves that are meant those to be sent; none below LIMIT_RESONANCE_WORD for the
 * heat alone. */
void motor_heat_lower(const motor_heat_t *self, card_drive_t *drive);

/** Makes of the waves that were sent those that were meant. */
void motor_heat_raise(const motor_heat_t *self, card_drive_t *drive);

/** motor_heat_lower() of waves; no other drive changes. */
static inline void motor_heat_tune(const motor_heat_t *self, card_drive_t *drive)
{
    if (drive->mode == (uint32_t)CARD_DRIVE_HIGH_FREQUENCY) {
        motor_heat_lower(self, drive);
    }
}

/** motor_heat_raise() of waves; no other drive changes. */
static inline void motor_heat_untune(const motor_heat_t *self, card_drive_t *drive)
{
    if (drive->mode == (uint32_t)CARD_DRIVE_HIGH_FREQUENCY) {
        motor_heat_raise(self, drive);
    }
}

/** @return what is left of `way_q16`, the way of a motor as its table has it */
static inline int64_t motor_heat_slow(uint32_t lost_q16, int64_t way_q16)
{
    return (lost_q16 == 0U) ? way_q16 : (way_q16 - ((way_q16 * (int64_t)lost_q16) / 65536));
}

#endif
