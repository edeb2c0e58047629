/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/admittance.h"

#include "base/fixed.h"

int64_t admittance_speed_q8(const hand_law_t *law, int32_t force_mn)
{
    const int64_t beyond_mn = (int64_t)force_mn - (int64_t)law->dead_zone_mn;
    const int64_t most_q8 = (int64_t)law->speed_ticks_per_s * 256;
    return fixed_within(beyond_mn * (int64_t)law->gain_q8, 0, most_q8);
}
