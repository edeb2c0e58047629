/* SPDX-License-Identifier: Apache-2.0 */
#include "sensor/force_channel.h"

#include "base/fixed.h"

#define HALF_Q30 UINT64_C(536870912)
#define MEAN_Q16 (65536U / LIMIT_FORCE_ZERO_CYCLES) /* A sum of so many readings times this. */

void force_channel_init(force_channel_t *self, const force_channel_config_t *config)
{
    const uint32_t zero_q16 = config->zero_count * 65536U;
    *self = (force_channel_t){.zero_q16 = (int32_t)zero_q16,
                              .doubts = force_doubt_bit(FORCE_DOUBT_NOT_ZEROED) |
                                        force_doubt_bit(FORCE_DOUBT_STALE)};
}

/* As if it had always been read. */
static void begin(force_channel_t *self, uint32_t count)
{
    self->doubts &= ~force_doubt_bit(FORCE_DOUBT_STALE);
    const uint32_t count_q16 = count * 65536U;
    self->outputs_q16[0] = (int32_t)count_q16;
    self->outputs_q16[1] = self->outputs_q16[0];
    self->counts[0] = (uint16_t)count;
    self->counts[1] = (uint16_t)count;
    self->still_cycles = 0U;
}

static uint32_t judge(const force_channel_t *self, const force_channel_config_t *config,
                      uint32_t count)
{
    const int32_t change = (int32_t)count - (int32_t)self->counts[0];
    const int32_t most = (int32_t)config->step_counts;
    uint32_t doubts = 0U;
    if ((count < config->minimum_count) || (count > config->maximum_count)) {
        doubts |= force_doubt_bit(FORCE_DOUBT_OUT_OF_RANGE);
        if ((count == 0U) || (count == FORCE_CHANNEL_FULL_SCALE)) {
            doubts |= force_doubt_bit(FORCE_DOUBT_BROKEN_WIRE);
        }
    }
    if ((change > most) || (change < -most)) {
        doubts |= force_doubt_bit(FORCE_DOUBT_STEP);
    }
    return doubts;
}

/* A reading that showed hardly any noise at rest may stand still under a force that stays. */
static uint32_t watch(force_channel_t *self, uint32_t count, bool is_moving)
{
    if (!is_moving || (count != (uint32_t)self->counts[0])) {
        self->still_cycles = 0U;
    } else if (!force_channel_is_still(self)) {
        self->still_cycles++;
    } else {
        /* It has been still for long enough. */
    }
    return (force_channel_is_still(self) && (self->noise_q8 > LIMIT_FORCE_STILL_NOISE))
               ? force_doubt_bit(FORCE_DOUBT_STUCK)
               : 0U;
}

static void filter(force_channel_t *self, const force_channel_config_t *config, uint32_t count)
{
    const uint32_t counts = count + (2U * (uint32_t)self->counts[0]) + (uint32_t)self->counts[1];
    const uint32_t counts_q16 = counts * 65536U;
    const int64_t sum_q46 = ((int64_t)config->filter_b_q30 * (int64_t)counts_q16) -
                            ((int64_t)config->filter_a1_q30 * (int64_t)self->outputs_q16[0]) -
                            ((int64_t)config->filter_a2_q30 * (int64_t)self->outputs_q16[1]);
    /* The lower half of a shift is that of any sign. */
    const uint64_t shifted_q16 = ((uint64_t)sum_q46 + HALF_Q30) >> 30U;
    const uint32_t output_q16 = (uint32_t)(shifted_q16 & 0xFFFFFFFFU);
    self->outputs_q16[1] = self->outputs_q16[0];
    self->outputs_q16[0] = (int32_t)output_q16;
    self->counts[1] = self->counts[0];
    self->counts[0] = (uint16_t)count;
}

uint32_t force_channel_step(force_channel_t *self, const force_channel_config_t *config,
                            uint32_t reading, bool is_moving)
{
    const uint32_t count =
        (reading < FORCE_CHANNEL_FULL_SCALE) ? reading : FORCE_CHANNEL_FULL_SCALE;
    if ((self->doubts & force_doubt_bit(FORCE_DOUBT_STALE)) != 0U) {
        begin(self, count);
    }
    const uint32_t doubts = judge(self, config, count) | watch(self, count, is_moving);
    self->doubts |= doubts;
    filter(self, config, count);
    return doubts;
}

static uint32_t slope_q16(const force_channel_config_t *config)
{
    return (uint32_t)fixed_magnitude((int64_t)config->mn_per_count_q16);
}

uint32_t force_channel_noise_mn(const force_channel_t *self, const force_channel_config_t *config)
{
    return (uint32_t)(((uint64_t)self->noise_q8 * slope_q16(config)) / 16777216U);
}

/* As many readings as 2^8 make the root of n x squares - sum^2 the deviation in 256ths. */
static uint16_t noise_of(const force_readings_t *readings)
{
    const uint64_t squares = (uint64_t)readings->squares * LIMIT_FORCE_ZERO_CYCLES;
    const uint64_t sum = readings->sum;
    const uint32_t noise_q8 = fixed_square_root(squares - (sum * sum));
    return (noise_q8 < UINT16_MAX) ? (uint16_t)noise_q8 : UINT16_MAX;
}

/* From where a zero counts as wandered. Held against the one before it, small steps would add up.
 */
static bool is_far(const force_channel_t *self, const force_channel_config_t *config,
                   int32_t zero_q16)
{
    int64_t from_q16 = (int64_t)self->first_q16;
    uint32_t most_mn = LIMIT_FORCE_DRIFT_MN;
    if (self->first_q16 == 0) {
        from_q16 = (int64_t)config->zero_count * 65536;
        most_mn = LIMIT_FORCE_WANDER_MN;
    }
    const int64_t away = fixed_magnitude((int64_t)zero_q16 - from_q16);
    return (away * (int64_t)slope_q16(config)) > ((int64_t)most_mn * INT64_C(4294967296));
}

force_zero_end_t force_channel_zero(force_channel_t *self, const force_channel_config_t *config,
                                    const force_readings_t *readings, int32_t *moved_mn)
{
    const uint32_t zero_q16 = readings->sum * MEAN_Q16;
    const int64_t moved_q16 = (int64_t)zero_q16 - (int64_t)self->zero_q16;
    force_zero_end_t end = FORCE_ZERO_END_DONE;
    *moved_mn = (int32_t)((moved_q16 * (int64_t)config->mn_per_count_q16) / INT64_C(4294967296));
    self->noise_q8 = noise_of(readings);
    self->still_cycles = 0U;
    if (force_channel_noise_mn(self, config) > LIMIT_FORCE_NOISE_MOST_MN) {
        end = FORCE_ZERO_END_NOISY;
    } else if (is_far(self, config, (int32_t)zero_q16)) {
        self->doubts |= force_doubt_bit(FORCE_DOUBT_ZERO_WANDERED);
        end = FORCE_ZERO_END_WANDERED;
    } else {
        self->zero_q16 = (int32_t)zero_q16;
        self->first_q16 = (self->first_q16 == 0) ? self->zero_q16 : self->first_q16;
        self->doubts = 0U;
    }
    return end;
}
