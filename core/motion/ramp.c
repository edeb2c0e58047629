/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ramp.h"

#include "base/fixed.h"

int64_t ramp_slower(int64_t speed_q8, int64_t down_q8)
{
    return fixed_within(speed_q8 - down_q8, 0, speed_q8);
}

int64_t ramp_way(int64_t speed_q8, int64_t down_q8)
{
    const uint32_t whole = (uint32_t)speed_q8 / (uint32_t)down_q8;
    const int64_t cycles = (int64_t)whole;
    return ((cycles + 1) * speed_q8) - ((down_q8 * cycles * (cycles + 1)) / 2);
}

int64_t ramp_next(int64_t now_q8, int64_t most_q8, const ramp_steps_t *steps, int64_t room)
{
    const int64_t slower = ramp_slower(now_q8, steps->down_q8);
    const int64_t fastest = fixed_within(most_q8, slower, now_q8 + steps->up_q8);
    const int64_t steady = (now_q8 < fastest) ? now_q8 : fastest;
    int64_t speed = slower;
    if (ramp_way(fastest, steps->down_q8) <= room) {
        speed = fastest;
    } else if (ramp_way(steady, steps->down_q8) <= room) {
        speed = steady;
    } else {
        /* A ramp down it is. */
    }
    return speed;
}

int32_t ramp_place(int32_t ticks, int64_t way, int32_t *rest)
{
    const int64_t more = (int64_t)*rest + way;
    const int64_t whole = fixed_divide_rounded(more, RAMP_TICK);
    *rest = (int32_t)(more - (whole * RAMP_TICK));
    return fixed_saturate((int64_t)ticks + whole);
}
