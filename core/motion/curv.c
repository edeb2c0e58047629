/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/curv.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"

#define SEGMENTS 64U
#define SEGMENT_BITS 25U /* Half a turn has 2^31 bam. */
#define SEGMENT_MASK 0x1FFFFFFU
#define ONE_Q16 65536
#define PERCENT 100U

/* exp(-d^2 / (2 c^2)) at d = n / 64 of half a turn, c = 60 degrees, 16 fraction bits. */
static const int32_t bell_q16[SEGMENTS + 1U] = {
    65536, 65464, 65249, 64891, 64394, 63760, 62995, 62101, 61086, 59956, 58717, 57378, 55947,
    54431, 52840, 51183, 49469, 47708, 45908, 44079, 42231, 40371, 38508, 36650, 34806, 32982,
    31185, 29421, 27696, 26014, 24382, 22801, 21276, 19810, 18404, 17061, 15780, 14564, 13412,
    12324, 11300, 10338, 9437,  8595,  7812,  7084,  6410,  5788,  5214,  4687,  4204,  3762,
    3360,  2994,  2662,  2361,  2090,  1846,  1627,  1431,  1255,  1099,  960,   837,   728};

/* Along a straight line between two points of the table. */
static int64_t bell_at(int32_t away_bam)
{
    const uint64_t away = (uint64_t)fixed_magnitude((int64_t)away_bam);
    const uint32_t place = (uint32_t)(away >> SEGMENT_BITS);
    int64_t value = (int64_t)bell_q16[SEGMENTS];
    if (place < SEGMENTS) {
        const uint32_t below = (uint32_t)away & SEGMENT_MASK;
        const int64_t into = (int64_t)below;
        const int64_t fall = (int64_t)bell_q16[place] - (int64_t)bell_q16[place + 1U];
        value = (int64_t)bell_q16[place] - fixed_shift_rounded(fall * into, SEGMENT_BITS);
    }
    return value;
}

/* Of the whole speed, 0..65536. */
static int64_t share_q16(uint32_t alpha_q16, int32_t away_bam)
{
    const int64_t alpha = fixed_within((int64_t)alpha_q16, 0, ONE_Q16);
    return ONE_Q16 - fixed_shift_rounded(alpha * bell_at(away_bam), 16U);
}

int64_t curv_speed_q8(const axis_config_t *config, const steering_t *steering, int32_t ticks)
{
    const int32_t away_bam =
        fixed_wrap_bam(joints_value(config, ticks) - (int64_t)steering->direction_bam);
    const int64_t most = (int64_t)config->speed_ticks_per_s * (int64_t)LIMIT_STEERING_SPEED_PERCENT;
    return fixed_divide_by(most * share_q16(steering->alpha_q16, away_bam), PERCENT * 256U);
}
