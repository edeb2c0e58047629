/* SPDX-License-Identifier: Apache-2.0 */
#include "sensor/force_sensor.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

#include <string.h>

void force_sensor_init(force_sensor_t *self, const force_config_t *config)
{
    (void)memset(self, 0, sizeof *self);
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        force_channel_init(&self->sealed.channels[i], &config->channels[i]);
    }
}

/* Two converters in a word, the first one high. */
static uint32_t reading_of(const uint32_t words[CARD_ADC_WORDS], uint32_t converter)
{
    const uint32_t word = words[(converter / 2U) % CARD_ADC_WORDS];
    const uint32_t shift = 16U - (16U * (converter % 2U));
    return (word >> shift) & 0xFFFFU;
}

void force_sensor_step(force_sensor_t *self, const force_config_t *config,
                       const uint32_t words[CARD_ADC_WORDS], bool is_moving)
{
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        const force_channel_config_t *const channel = &config->channels[i];
        const uint32_t reading = reading_of(words, channel->converter);
        self->untrue[i] =
            force_channel_step(&self->sealed.channels[i], channel, reading, is_moving) &
            FORCE_CHANNEL_UNTRUE;
        self->sealed.force_mn[i] = force_channel_mn(&self->sealed.channels[i], channel);
    }
    self->sealed.zero_cycles += force_sensor_is_old(self) ? 0U : 1U;
}

void force_sensor_miss(force_sensor_t *self, bool is_lost)
{
    const uint32_t also = is_lost ? force_doubt_bit(FORCE_DOUBT_NOT_ZEROED) : 0U;
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        self->sealed.channels[i].doubts |= force_doubt_bit(FORCE_DOUBT_STALE) | also;
        self->untrue[i] = force_doubt_bit(FORCE_DOUBT_STALE);
    }
}

void force_sensor_distrust(force_sensor_t *self)
{
    self->sealed.zeroing = 0U;
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        self->sealed.channels[i].doubts |= force_doubt_bit(FORCE_DOUBT_NOT_ZEROED);
    }
}

void force_sensor_grow_old(force_sensor_t *self)
{
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        self->sealed.channels[i].doubts |= force_doubt_bit(FORCE_DOUBT_ZERO_OLD);
    }
}

void force_sensor_begin_zero(force_sensor_t *self)
{
    self->sealed.zero_cycles = 0U;
    (void)memset(self->readings, 0, sizeof self->readings);
    self->sealed.left_readings = (uint16_t)LIMIT_FORCE_ZERO_CYCLES;
    self->sealed.zeroing = (uint8_t)((1U << ROBOT_FORCE_CHANNELS) - 1U);
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        self->sealed.channels[i].doubts |= force_doubt_bit(FORCE_DOUBT_NOT_ZEROED);
        self->sealed.channels[i].doubts &= ~force_doubt_bit(FORCE_DOUBT_TOO_QUIET); /* Anew. */
    }
}

static void add(force_readings_t *readings, uint32_t count)
{
    readings->sum += count;
    readings->squares += count * count;
}

/* The converter of a live sensor does not read the same each time. */
static void doubt_dead(force_channel_t *channel)
{
    if ((channel->noise_q8 < LIMIT_FORCE_LIVE_NOISE) && force_channel_is_believed(channel)) {
        channel->doubts |= force_doubt_bit(FORCE_DOUBT_TOO_QUIET);
    }
}

/* One channel that is zeroed. True when that has ended. */
static bool zero_channel(force_sensor_t *self, const force_config_t *config, uint32_t index,
                         bool is_calm, force_zeroed_t *zeroed)
{
    force_channel_t *const channel = &self->sealed.channels[index];
    bool has_ended = true;
    if (!is_calm) {
        zeroed->ends[index] = FORCE_ZERO_END_MOVED;
    } else if (self->untrue[index] != 0U) {
        zeroed->ends[index] = FORCE_ZERO_END_UNREAD;
    } else if (self->sealed.left_readings == 0U) {
        zeroed->ends[index] = force_channel_zero(channel, &config->channels[index],
                                                 &self->readings[index], &zeroed->moved_mn[index]);
        self->sealed.force_mn[index] = force_channel_mn(channel, &config->channels[index]);
        doubt_dead(channel);
    } else {
        has_ended = false;
    }
    return has_ended;
}

force_zeroed_t force_sensor_zero(force_sensor_t *self, const force_config_t *config, bool is_fresh,
                                 bool is_calm)
{
    force_zeroed_t zeroed;
    (void)memset(&zeroed, 0, sizeof zeroed);
    if (is_fresh) {
        self->sealed.left_readings--;
    }
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        const uint32_t bit = (uint32_t)1U << i;
        if (((uint32_t)self->sealed.zeroing & bit) == 0U) {
            continue;
        }
        if (is_fresh) {
            add(&self->readings[i], self->sealed.channels[i].counts[0]);
        }
        if (zero_channel(self, config, i, is_calm, &zeroed)) {
            zeroed.ended |= bit;
        }
    }
    self->sealed.zeroing = (uint8_t)((uint32_t)self->sealed.zeroing & ~zeroed.ended);
    return zeroed;
}

static bool is_beyond(int32_t force_mn)
{
    return fixed_magnitude((int64_t)force_mn) > (int64_t)LIMIT_FORCE_PAIR_MN;
}

bool force_sensor_is_loaded(const force_sensor_t *self)
{
    return is_beyond(self->sealed.force_mn[FORCE_CHANNEL_HAND]) &&
           is_beyond(self->sealed.force_mn[FORCE_CHANNEL_NEEDLE]) &&
           force_channel_is_believed(&self->sealed.channels[FORCE_CHANNEL_HAND]) &&
           force_channel_is_believed(&self->sealed.channels[FORCE_CHANNEL_NEEDLE]);
}

void force_sensor_judge_pair(force_sensor_t *self, bool is_needle_free, bool is_driven_in)
{
    const bool is_pulled_in = is_driven_in && (self->sealed.force_mn[FORCE_CHANNEL_HAND] > 0) &&
                              (self->sealed.force_mn[FORCE_CHANNEL_NEEDLE] < 0);
    if (!is_needle_free && !is_pulled_in) {
        self->sealed.pair_cycles = 0U;
        return;
    }
    self->sealed.pair_cycles++;
    if (self->sealed.pair_cycles >= LIMIT_FORCE_PAIR_CYCLES) {
        self->sealed.pair_cycles = 0U;
        const force_doubt_t doubt =
            is_needle_free ? FORCE_DOUBT_FREE_NEEDLE_LOADED : FORCE_DOUBT_NEEDLE_PULLED_IN;
        self->sealed.channels[FORCE_CHANNEL_HAND].doubts |= force_doubt_bit(doubt);
        self->sealed.channels[FORCE_CHANNEL_NEEDLE].doubts |= force_doubt_bit(doubt);
    }
}
