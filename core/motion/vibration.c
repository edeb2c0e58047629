/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/vibration.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "motion/ramp.h"

/* A stroke and the rest before it. */
static uint32_t leg_cycles(const vibration_law_t *law)
{
    return law->dwell_cycles + law->stroke_cycles;
}

static uint32_t train_cycles(const vibration_law_t *law)
{
    return (law->periods == 0U) ? 0U : ((2U * law->periods * leg_cycles(law)) + law->dwell_cycles);
}

/* From the nearer end of the stroke, `cycle` away: the way and, in magnitude, the speed. */
static vibration_point_t near_end(const vibration_law_t *law, uint32_t cycle)
{
    const uint32_t square = law->stroke_cycles * law->stroke_cycles;
    const int64_t way = 4 * (int64_t)law->amplitude_ticks * (int64_t)cycle;
    const int64_t doubled_ticks = fixed_divide_by(way * (int64_t)cycle, square);
    const vibration_point_t point = {.behind_ticks = (int32_t)((doubled_ticks + 1) / 2),
                                     .speed_ticks_per_s_q8 =
                                         (int32_t)fixed_divide_by(way * RAMP_TICK, square)};
    return point;
}

/* `cycle` cycles after the stroke began, outwards. */
static vibration_point_t stroke_at(const vibration_law_t *law, uint32_t cycle)
{
    const uint32_t left = law->stroke_cycles - cycle;
    vibration_point_t point;
    if (cycle <= left) {
        point = near_end(law, cycle);
    } else {
        point = near_end(law, left);
        point.behind_ticks = (int32_t)law->amplitude_ticks - point.behind_ticks;
    }
    return point;
}

vibration_point_t vibration_at(const vibration_law_t *law, uint32_t cycle)
{
    vibration_point_t point = {.is_over = true};
    if ((cycle < train_cycles(law)) && (law->stroke_cycles <= LIMIT_VIBRATION_STROKE_CYCLES)) {
        const uint32_t leg = cycle / leg_cycles(law);
        const uint32_t in_leg = cycle % leg_cycles(law);
        const uint32_t in_stroke = (in_leg > law->dwell_cycles) ? (in_leg - law->dwell_cycles) : 0U;
        point = (in_stroke > 0U) ? stroke_at(law, in_stroke) : (vibration_point_t){0, 0, false};
        if ((leg % 2U) != 0U) {
            point.behind_ticks = (int32_t)law->amplitude_ticks - point.behind_ticks;
        } else {
            point.speed_ticks_per_s_q8 = -point.speed_ticks_per_s_q8;
        }
    }
    return point;
}
