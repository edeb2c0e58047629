/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * One channel of the force sensor: its readings become a filtered force in mN, and whatever speaks
 * against that is a doubt with a name. A doubt says nothing of motion: who follows a force asks
 * force_channel_is_believed() in each cycle. Its owner holds it under seal.
 *
 * The filter is a Butterworth low-pass of second order (Oppenheim and Schafer, Discrete-Time Signal
 * Processing, 7.1); its coefficients are of the robot file. Noise is that of single readings: of
 * white noise the filter lets about 1.1 x corner / 500 Hz of its power through.
 */
#ifndef BORESIGHT_FORCE_CHANNEL_H
#define BORESIGHT_FORCE_CHANNEL_H

#include "interface/force_doubt.h"
#include "limits/requirement_limits.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

#define FORCE_CHANNEL_FULL_SCALE 4095U /**< Largest reading of the converter. */

/** No padding. */
typedef struct {
    int32_t outputs_q16[2]; /**< Last two outputs of the filter, counts; the last one first. */
    uint16_t counts[2];     /**< Last two readings, the same. */
    int32_t zero_q16;       /**< Reading without a force, counts. */
    int32_t first_q16;      /**< The same, as it was taken first; 0 before that. */
    uint16_t noise_q8;      /**< Standard deviation of readings at the last zeroing; saturates. */
    uint16_t still_cycles;  /**< Cycles of a motion since the reading has changed, to
                               LIMIT_FORCE_STILL_CYCLES. */
    uint32_t doubts;        /**< Bits of force_doubt_t. */
} force_channel_t;

/** Readings of a zeroing so far. */
typedef struct {
    uint32_t sum;     /**< Of LIMIT_FORCE_ZERO_CYCLES readings of 12 bits at most, as the next. */
    uint32_t squares; /**< Sum of their squares. */
} force_readings_t;

/** The bit of a doubt. */
static inline uint32_t force_doubt_bit(force_doubt_t doubt)
{
    return (uint32_t)1U << (uint32_t)doubt;
}

/** Doubts that say that a reading itself cannot be true. */
#define FORCE_CHANNEL_UNTRUE                                                                       \
    (force_doubt_bit(FORCE_DOUBT_STALE) | force_doubt_bit(FORCE_DOUBT_OUT_OF_RANGE) |              \
     force_doubt_bit(FORCE_DOUBT_STEP) | force_doubt_bit(FORCE_DOUBT_BROKEN_WIRE))

/**
 * Starts without a reading and not zeroed, by the zero of the robot file.
 *
 * @satisfies SWR-FORCE-563
 */
void force_channel_init(force_channel_t *self, const force_channel_config_t *config);

/**
 * A report came: takes `reading`; one above FORCE_CHANNEL_FULL_SCALE counts as that. The first one
 * after a stale force begins the filter anew. `is_moving`: an axis moves.
 *
 * @return bits of force_doubt_t that this reading alone gives cause for
 *
 * @satisfies SWR-COOP-016
 * @satisfies SWR-FORCE-562
 * @satisfies SWR-FORCE-565
 * @satisfies SWR-FORCE-566
 * @satisfies SWR-FORCE-567
 * @satisfies SWR-FORCE-568
 */
uint32_t force_channel_step(force_channel_t *self, const force_channel_config_t *config,
                            uint32_t reading, bool is_moving);

/** No report has come for LIMIT_FORCE_STALE_CYCLES. */
static inline void force_channel_miss(force_channel_t *self)
{
    self->doubts |= force_doubt_bit(FORCE_DOUBT_STALE);
}

/**
 * @return the filtered force, mN; a push is positive
 *
 * @satisfies SWR-FORCE-561
 */
static inline int32_t force_channel_mn(const force_channel_t *self,
                                       const force_channel_config_t *config)
{
    const int64_t counts_q16 = (int64_t)self->outputs_q16[0] - (int64_t)self->zero_q16;
    return (int32_t)((counts_q16 * (int64_t)config->mn_per_count_q16) / INT64_C(4294967296));
}

/** @return the force of the present zero by that of the robot file, mN */
static inline int32_t force_channel_zero_mn(const force_channel_t *self,
                                            const force_channel_config_t *config)
{
    const int64_t moved_q16 = (int64_t)self->zero_q16 - ((int64_t)config->zero_count * 65536);
    return (int32_t)((moved_q16 * (int64_t)config->mn_per_count_q16) / INT64_C(4294967296));
}

/** @return the standard deviation of single readings at the last zeroing, mN; 0 before it */
uint32_t force_channel_noise_mn(const force_channel_t *self, const force_channel_config_t *config);

/**
 * The reading has not changed in LIMIT_FORCE_STILL_CYCLES of a motion. That is a doubt only of a
 * channel with noise: a quiet one shows a force that stays as one reading, as a stuck one does.
 *
 * @satisfies SWR-COOP-750
 */
static inline bool force_channel_is_still(const force_channel_t *self)
{
    return self->still_cycles >= LIMIT_FORCE_STILL_CYCLES;
}

/** Nothing speaks against its force. */
static inline bool force_channel_is_believed(const force_channel_t *self)
{
    return self->doubts == 0U;
}

/**
 * Judges LIMIT_FORCE_ZERO_CYCLES readings: their mean becomes the zero, if it is near enough to
 * that of the robot file, later to the first one that was taken, and they are calm enough, and the
 * doubts end; else the channel is not zeroed.
 *
 * @param moved_mn  force that the mean means by the zero before
 * @return FORCE_ZERO_END_DONE, NOISY or WANDERED
 *
 * @satisfies SWR-FORCE-570
 * @satisfies SWR-FORCE-571
 * @satisfies SWR-FORCE-572
 * @satisfies SWR-FORCE-574
 * @satisfies SWR-FORCE-611
 */
force_zero_end_t force_channel_zero(force_channel_t *self, const force_channel_config_t *config,
                                    const force_readings_t *readings, int32_t *moved_mn);

#endif
