/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/velocity/velocity_ramp.h"

#include "base/fixed.h"

int64_t velocity_ramp_slower(int64_t speed_q8, int64_t step_q8)
{
    return fixed_within(speed_q8 - step_q8, 0, speed_q8);
}

int64_t velocity_ramp_way(int64_t speed_q8, int64_t step_q8)
{
    const uint32_t whole = (uint32_t)speed_q8 / (uint32_t)step_q8;
    const int64_t cycles = (int64_t)whole;
    return ((cycles + 1) * speed_q8) - ((step_q8 * cycles * (cycles + 1)) / 2);
}

int64_t velocity_ramp_next(int64_t now_q8, int64_t most_q8, int64_t step_q8, int64_t room)
{
    const int64_t slower = velocity_ramp_slower(now_q8, step_q8);
    const int64_t fastest = fixed_within(most_q8, slower, now_q8 + step_q8);
    const int64_t steady = (now_q8 < fastest) ? now_q8 : fastest;
    int64_t speed = slower;
    if (velocity_ramp_way(fastest, step_q8) <= room) {
        speed = fastest;
    } else if (velocity_ramp_way(steady, step_q8) <= room) {
        speed = steady;
    } else {
        /* A ramp down it is. */
    }
    return speed;
}
