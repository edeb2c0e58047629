/* SPDX-License-Identifier: Apache-2.0 */
/* Fixed point, as far as bits decide it: ranges for every angle and every factor. Errors, roots and
 * quotients are shown by tests of every value or of many. */
#include "prove.h"

#include "base/fixed.h"

void prove_SWR_FIX_001_sine_and_cosine_stay_within_one(void)
{
    int32_t angle_bam;
    const fixed_direction_t direction = fixed_direction(angle_bam);
    PROVE((direction.cosine_q30 >= -FIXED_ONE_Q30) && (direction.cosine_q30 <= FIXED_ONE_Q30),
          "SWR-FIX-001: the cosine lies between -1 and 1");
    PROVE((direction.sine_q30 >= -FIXED_ONE_Q30) && (direction.sine_q30 <= FIXED_ONE_Q30),
          "SWR-FIX-001: the sine lies between -1 and 1");
    POSSIBLE(direction.sine_q30 == FIXED_ONE_Q30, "a quarter turn");
}

void prove_SWR_FIX_003_any_angle_is_wrapped_to_one_turn(void)
{
    int64_t value;
    const int32_t angle = fixed_wrap_bam(value);
    PROVE((uint32_t)angle == (uint32_t)((uint64_t)value & 0xFFFFFFFFU),
          "SWR-FIX-003: the angle is the same but for whole turns");
    POSSIBLE(angle < 0, "a negative angle");
}

void prove_SWR_FIX_003_a_number_is_saturated_or_kept_within_its_ends(void)
{
    int64_t value;
    int64_t minimum;
    int64_t maximum;
    assume(minimum <= maximum);
    const int32_t narrow = fixed_saturate(value);
    const int64_t within = fixed_within(value, minimum, maximum);
    PROVE(IMPLIES((value >= INT32_MIN) && (value <= INT32_MAX), (int64_t)narrow == value),
          "SWR-FIX-003: what fits is kept");
    PROVE(IMPLIES(value > INT32_MAX, narrow == INT32_MAX) &&
              IMPLIES(value < INT32_MIN, narrow == INT32_MIN),
          "SWR-FIX-003: what does not fit is the nearest that does");
    PROVE((within >= minimum) && (within <= maximum), "SWR-FIX-003: within its ends");
    PROVE(IMPLIES((value >= minimum) && (value <= maximum), within == value),
          "SWR-FIX-003: what lies within is kept");
    POSSIBLE((int64_t)narrow != value, "one that does not fit");
}

/* Positions of a cubic have 8 fraction bits: contract of motion/prove_cubic.c. */
void prove_SWR_FIX_003_eight_fraction_bits_are_rounded_half_away_from_zero(void)
{
    int64_t value;
    assume((value >= -(INT64_C(1) << 40)) && (value <= (INT64_C(1) << 40)));
    const int64_t ticks = fixed_shift_rounded(value, 8U);
    PROVE(ticks == ((value < 0) ? -((128 - value) / 256) : ((value + 128) / 256)),
          "SWR-FIX-003: the nearest tick, of two the one further away from zero");
    POSSIBLE(ticks < 0, "a negative tick");
}
