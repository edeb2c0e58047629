/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The force sensor: its two channels, the zeroing of both, and pairs of forces that the mechanism
 * makes impossible. The controller owns one and steps it in each cycle of a robot that has one;
 * what it knows of axes and needle, it hands in.
 */
#ifndef BORESIGHT_FORCE_SENSOR_H
#define BORESIGHT_FORCE_SENSOR_H

#include "card/card.h"
#include "limits/requirement_limits.h"
#include "sensor/force_channel.h"

#include <stdbool.h>
#include <stdint.h>

/** Under seal. No padding. */
typedef struct {
    force_channel_t channels[ROBOT_FORCE_CHANNELS];
    uint16_t left_readings; /**< Until the zeroing is judged. */
    uint8_t zeroing;        /**< Bit n: channel n is being zeroed. */
    uint8_t pair_cycles;    /**< An impossible pair has lasted so long; saturates. */
    uint32_t zero_cycles;   /**< Reports since the zeroing began, to LIMIT_FORCE_ZERO_AGE_CYCLES. */
    int32_t force_mn[ROBOT_FORCE_CHANNELS]; /**< In this cycle. */
} force_sensor_sealed_t;

typedef struct {
    force_sensor_sealed_t sealed;
    force_readings_t readings[ROBOT_FORCE_CHANNELS]; /**< Under seal while one is zeroed. */
    uint32_t untrue[ROBOT_FORCE_CHANNELS];           /**< FORCE_CHANNEL_UNTRUE of this cycle. */
} force_sensor_t;

/** Ends of zeroings in a cycle. */
typedef struct {
    uint32_t ended; /**< Bit n: the zeroing of channel n has ended; those below are valid. */
    force_zero_end_t ends[ROBOT_FORCE_CHANNELS];
    int32_t moved_mn[ROBOT_FORCE_CHANNELS]; /**< As force_channel_zero() has it; otherwise 0. */
} force_zeroed_t;

/** Starts as force_channel_init(); also after its memory was damaged. */
void force_sensor_init(force_sensor_t *self, const force_config_t *config);

/** A report came; `words` are those of its converters. `is_moving`: an axis moves. */
void force_sensor_step(force_sensor_t *self, const force_config_t *config,
                       const uint32_t words[CARD_ADC_WORDS], bool is_moving);

/**
 * No report came, for LIMIT_FORCE_STALE_CYCLES or more; or the card is not to be believed,
 * `is_lost`, and what it measures afterwards has to be zeroed anew.
 *
 * @satisfies SWR-FORCE-564
 */
void force_sensor_miss(force_sensor_t *self, bool is_lost);

/** Its table is damaged: nothing that it measures is believed until it is zeroed by a whole one. */
void force_sensor_distrust(force_sensor_t *self);

/** The zero is as old as one may be. */
static inline bool force_sensor_is_old(const force_sensor_t *self)
{
    return self->sealed.zero_cycles >= LIMIT_FORCE_ZERO_AGE_CYCLES;
}

/**
 * The zero is doubted for its age.
 *
 * @satisfies SWR-FORCE-610
 */
void force_sensor_grow_old(force_sensor_t *self);

/** A zeroing runs. */
static inline bool force_sensor_is_zeroing(const force_sensor_t *self)
{
    return self->sealed.zeroing != 0U;
}

/** Both channels are zeroed from the next report on; neither is until then. */
void force_sensor_begin_zero(force_sensor_t *self);

/**
 * The zeroing in this cycle, after the step; `is_fresh`: a report came. While not `is_calm`, as
 * something is armed, an axis moves or the needle is not known to be out, there is none.
 *
 * @satisfies SWR-FORCE-574
 * @satisfies SWR-FORCE-700
 */
force_zeroed_t force_sensor_zero(force_sensor_t *self, const force_config_t *config, bool is_fresh,
                                 bool is_calm);

/** Both forces are believed, and beyond LIMIT_FORCE_PAIR_MN. */
bool force_sensor_is_loaded(const force_sensor_t *self);

/**
 * Of loaded channels, in each cycle: `is_needle_free`, the needle is out and stands; or
 * `is_driven_in`, it is driven inwards. Neither, or not loaded: the time begins anew.
 *
 * @satisfies SWR-FORCE-569
 */
void force_sensor_judge_pair(force_sensor_t *self, bool is_needle_free, bool is_driven_in);

#endif
