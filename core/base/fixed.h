/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Fixed-point arithmetic: q30 (1.0 = 2^30, range [-2, 2)), angles in bam (2^32 = one turn, wraps by
 * itself), lengths in nm. Pure functions, bit-identical on every target, free of overflow for every
 * argument.
 */
#ifndef BORESIGHT_FIXED_H
#define BORESIGHT_FIXED_H

#include <stdint.h>

#define FIXED_ONE_Q30 INT32_C(1073741824)

/** Cosine and sine of one angle. */
typedef struct {
    int32_t cosine_q30;
    int32_t sine_q30;
} fixed_direction_t;

/**
 * Cosine and sine of `angle_bam`, each within 4 units of q30; exact at multiples of a quarter turn.
 *
 * @satisfies SWR-FIX-001
 */
fixed_direction_t fixed_direction(int32_t angle_bam);

/**
 * `numerator / divisor`, the divisor not 0. For a processor without a division: by the reciprocal,
 * half of the instructions, if the divisor has 32 bits.
 *
 * @satisfies SWR-FIX-003
 * @satisfies SWR-PROOF-800
 */
uint64_t fixed_divide(uint64_t numerator, uint64_t divisor);

/**
 * Angle of the vector (x, y), in [-half a turn, half a turn), within 4 bam of the true value; (0,
 * 0) gives 0. x and y may have any equal scale.
 *
 * @satisfies SWR-FIX-001
 */
int32_t fixed_atan2_bam(int64_t y, int64_t x);

/**
 * Largest integer whose square is not above `value`.
 *
 * @satisfies SWR-FIX-002
 */
uint32_t fixed_square_root(uint64_t value);

/** `a * b` where `b_q30` is a fraction, rounded half away from zero, saturated to int32. */
int32_t fixed_multiply_q30(int32_t a, int32_t b_q30);

/**
 * Length of `vector`, rounded, and the unit vector along it, each coordinate within 4 units of q30.
 * |coordinate| <= 2^60. The zero vector gives length 0 and the zero vector.
 */
int64_t fixed_normalise(const int64_t vector[3], int32_t unit_q30[3]);

/** Length of `vector` as fixed_normalise() gives it, without its divisions. */
int64_t fixed_length(const int64_t vector[3]);

/**
 * `value` limited to int32.
 *
 * @satisfies SWR-FIX-003
 */
static inline int32_t fixed_saturate(int64_t value)
{
    if (value > INT32_MAX) {
        return INT32_MAX;
    }
    return (value < INT32_MIN) ? INT32_MIN : (int32_t)value;
}

/** `value` without its sign; not for INT64_MIN. */
static inline int64_t fixed_magnitude(int64_t value)
{
    return (value < 0) ? -value : value;
}

/** The larger of `a` and `b`. */
static inline int64_t fixed_larger(int64_t a, int64_t b)
{
    return (a > b) ? a : b;
}

/** `value` modulo one turn: the angle it stands for, whichever number of turns it counts. */
int32_t fixed_wrap_bam(int64_t value);

/**
 * `value / divisor` as C rounds it, towards zero; `divisor` 2..65536. With a constant divisor a
 * quarter of the instructions of a division of 64 bits: three digits of 16 bits, each divided as
 * the compiler divides 32 bits by a constant.
 *
 * @satisfies SWR-FIX-003
 */
static inline int64_t fixed_divide_by(int64_t value, uint32_t divisor)
{
    const uint64_t size = (value < 0) ? (0ULL - (uint64_t)value) : (uint64_t)value;
    const uint32_t upper = (uint32_t)(size >> 32U);
    const uint32_t lower = (uint32_t)(size & 0xFFFFFFFFU);
    const uint32_t middle = ((upper % divisor) << 16U) | (lower >> 16U);
    const uint32_t last = ((middle % divisor) << 16U) | (lower & 0xFFFFU);
    const uint32_t high = upper / divisor;
    const uint32_t low = ((middle / divisor) << 16U) | (last / divisor);
    const uint64_t quotient = ((uint64_t)high << 32U) | low;
    return (value < 0) ? -(int64_t)quotient : (int64_t)quotient;
}

/**
 * `value / divisor` as C rounds it, towards zero; `divisor` above 0. By fixed_divide().
 *
 * @satisfies SWR-FIX-003
 * @satisfies SWR-PROOF-800
 */
int64_t fixed_divide_signed(int64_t value, int64_t divisor);

/**
 * `numerator / denominator` rounded half away from zero. Requires (contract 100) denominator > 0.
 *
 * @satisfies SWR-PROOF-800
 */
int64_t fixed_divide_rounded(int64_t numerator, int64_t denominator);

/** `value / 2^bits` rounded half away from zero, bits 1..62. */
static inline int64_t fixed_shift_rounded(int64_t value, uint32_t bits)
{
    const uint32_t below = bits - 1U;
    const uint64_t half = 1ULL << below;
    const uint64_t size = (value < 0) ? (0ULL - (uint64_t)value) : (uint64_t)value;
    const uint64_t moved = (size + half) >> bits;
    return (value < 0) ? -(int64_t)moved : (int64_t)moved;
}

/** Scalar product of `a` and `b_q30`, rounded; in the unit of `a`. */
static inline int64_t fixed_dot_q30(const int32_t a[3], const int32_t b_q30[3])
{
    const int64_t halved = (((int64_t)a[0] * b_q30[0]) / 2) + (((int64_t)a[1] * b_q30[1]) / 2) +
                           (((int64_t)a[2] * b_q30[2]) / 2);
    return fixed_shift_rounded(halved, 29U);
}

/** `value`, or the end of [minimum, maximum] that it is beyond. */
static inline int64_t fixed_within(int64_t value, int64_t minimum, int64_t maximum)
{
    if (value < minimum) {
        return minimum;
    }
    return (value > maximum) ? maximum : value;
}

#endif
