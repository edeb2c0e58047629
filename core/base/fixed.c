/* SPDX-License-Identifier: Apache-2.0 */
#include "base/fixed.h"

#include "base/contract.h"

#include <stdbool.h>

#define ONE_Q32 0x100000000ULL
#define TWO_PI_Q29 3373259426ULL
#define BAM_PER_RADIAN 683565276U

static uint64_t magnitude(int64_t value)
{
    return (value < 0) ? (0ULL - (uint64_t)value) : (uint64_t)value;
}

/* In two halves, because a size of 2^63 has a negative but no positive int64. */
static int64_t with_sign(uint64_t size, bool is_negative)
{
    const uint64_t half = size / 2U;
    const uint64_t rest = size - half;
    const int64_t sum = -(int64_t)half;
    return is_negative ? (sum - (int64_t)rest) : (int64_t)size;
}

/* The int32 with these bits, without a conversion that C leaves to the compiler. */
static int32_t signed_bits(uint32_t bits)
{
    const uint32_t inverted = 0xFFFFFFFFU - bits;
    return (bits > inverted) ? ((-1) - (int32_t)inverted) : (int32_t)bits;
}

static uint64_t multiply_q32(uint64_t a, uint64_t b)
{
    return (a * b) >> 32U;
}

/* Two numbers of 32 bits need a quarter of the instructions. */
static uint32_t multiply_short_q32(uint32_t a, uint32_t b)
{
    return (uint32_t)(((uint64_t)a * b) >> 32U);
}

/* Moves a number whose highest `bits` are zero up by so many; returns how many. */
static inline uint32_t lift(uint64_t *value, uint32_t bits)
{
    if ((*value >> (64U - bits)) != 0U) {
        return 0U;
    }
    *value <<= bits;
    return bits;
}

/* 1 / `value_q32` of a half to one, q31, too small by 3 at most (every value was tried): Newton's
 * method from a straight line that is at most 6 % off, of which each step leaves the square. No
 * step gives too much, as what is left of two is rounded down, too: so 32 bits hold it. */
static uint32_t reciprocal_q31(uint32_t value_q32)
{
    uint32_t reciprocal = (uint32_t)(6063482000ULL - multiply_short_q32(value_q32, 4042322000U));
    for (uint32_t i = 0U; i < 3U; i++) {
        const uint32_t rest_q31 = 0xFFFFFFFFU - multiply_short_q32(reciprocal, value_q32);
        reciprocal = (uint32_t)(((uint64_t)reciprocal * rest_q31) >> 31U);
    }
    return reciprocal;
}

uint64_t fixed_divide(uint64_t numerator, uint64_t divisor)
{
    uint64_t wide = divisor << 32U;
    uint32_t shift = 0U;
    if (divisor > UINT32_MAX) {
        return numerator / divisor;
    }
    shift += lift(&wide, 16U);
    shift += lift(&wide, 8U);
    shift += lift(&wide, 4U);
    shift += lift(&wide, 2U);
    shift += lift(&wide, 1U);
    const uint64_t reciprocal = reciprocal_q31((uint32_t)(wide >> 32U));
    const uint32_t below = 31U - shift;
    uint64_t quotient = 0U;
    uint64_t rest = numerator;
    /* The first step leaves a 2^28th of the quotient, the second one a 2^28th of that. */
    for (uint32_t i = 0U; i < 2U; i++) {
        const uint64_t part =
            (((rest >> 32U) * reciprocal) + multiply_q32(rest & 0xFFFFFFFFU, reciprocal)) >> below;
        quotient += part;
        rest -= part * divisor;
    }
    while (rest >= divisor) {
        rest -= divisor;
        quotient++;
    }
    return quotient;
}

static uint32_t bit_length(uint64_t value)
{
    const uint32_t upper = (uint32_t)(value >> 32U);
    uint32_t length = 0U;
    uint32_t rest = (uint32_t)(value & 0xFFFFFFFFU);
    if (upper != 0U) {
        length = 32U;
        rest = upper;
    }
    for (uint32_t step = 16U; step > 0U; step >>= 1U) {
        if ((rest >> step) != 0U) {
            rest >>= step;
            length += step;
        }
    }
    return length + rest;
}

/* Moves the highest bit of a number of `length` bits to bit 30. */
static uint64_t to_31_bits(uint64_t value, uint32_t length)
{
    if (length > 31U) {
        const uint32_t excess = length - 31U;
        return value >> excess;
    }
    const uint32_t lack = 31U - length;
    return value << lack;
}

/* Taylor series, the angle at most an eighth of a turn: the first term left out is below 2^-37. */
static uint64_t sine_q32(uint32_t angle_q32, uint32_t square_q32)
{
    uint32_t sum = 0x2E3CU - multiply_short_q32(square_q32, 0x6CU);
    sum = 0xD00D0U - multiply_short_q32(square_q32, sum);
    sum = 0x2222222U - multiply_short_q32(square_q32, sum);
    sum = 0x2AAAAAABU - multiply_short_q32(square_q32, sum);
    return multiply_q32(angle_q32, ONE_Q32 - multiply_short_q32(square_q32, sum));
}

static uint64_t cosine_q32(uint32_t square_q32)
{
    uint32_t sum = 0x4A0U - multiply_short_q32(square_q32, 0x9U);
    sum = 0x1A01AU - multiply_short_q32(square_q32, sum);
    sum = 0x5B05B0U - multiply_short_q32(square_q32, sum);
    sum = 0xAAAAAABU - multiply_short_q32(square_q32, sum);
    sum = 0x80000000U - multiply_short_q32(square_q32, sum);
    return ONE_Q32 - multiply_short_q32(square_q32, sum);
}

fixed_direction_t fixed_direction(int32_t angle_bam)
{
    const uint32_t turned = (uint32_t)angle_bam + 0x20000000U;
    const uint32_t in_quadrant = turned & 0x3FFFFFFFU;
    const int32_t offset = (int32_t)in_quadrant - 0x20000000;
    const uint32_t angle_q32 = (uint32_t)((magnitude(offset) * TWO_PI_Q29) >> 29U);
    const uint32_t square_q32 = multiply_short_q32(angle_q32, angle_q32);
    const uint64_t cosine_q30 = (cosine_q32(square_q32) + 2U) >> 2U;
    const uint64_t sine_q30 = (sine_q32(angle_q32, square_q32) + 2U) >> 2U;
    const int32_t cosine = (int32_t)cosine_q30;
    const int32_t sine = (offset < 0) ? -(int32_t)sine_q30 : (int32_t)sine_q30;
    fixed_direction_t direction;
    switch (turned >> 30U) {
    case 0U:
        direction = (fixed_direction_t){cosine, sine};
        break;
    case 1U:
        direction = (fixed_direction_t){-sine, cosine};
        break;
    case 2U:
        direction = (fixed_direction_t){-cosine, -sine};
        break;
    default:
        direction = (fixed_direction_t){sine, -cosine};
        break;
    }
    return direction;
}

/* Number of sixteenths of `larger`, which has 31 bits, in `smaller`; `above`: sixteen times the
 * rest. */
static uint32_t count_sixteenths(uint32_t smaller, uint32_t larger, uint32_t *above)
{
    uint32_t count = 0U;
    uint32_t rest = smaller;
    if (smaller == larger) {
        count = 1U;
        rest = 0U;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        rest *= 2U;
        count *= 2U;
        if (rest >= larger) {
            rest -= larger;
            count++;
        }
    }
    *above = rest;
    return count;
}

/* above / divisor, q32; `above` below a sixteenth of `divisor`, which has 35 or 36 bits. Divided by
 * the upper 32 bits of it, it is too large by one at most: a quarter of the quotient's last bit. */
static uint32_t sixteenth_q32(uint64_t above, uint64_t divisor)
{
    uint64_t quotient = fixed_divide(above << 28U, divisor >> 4U);
    if ((quotient * divisor) > (above << 32U)) {
        quotient--;
    }
    return (uint32_t)quotient;
}

/* Angle of a vector in the first octant; `larger` has 31 bits. The nearest smaller sixteenth is
   taken from the table, the rest is at most 1/16 and its series ends below 2^-38. */
static uint32_t octant_angle(uint32_t smaller, uint32_t larger)
{
    /* atan(k / 16) in bam. */
    static const uint32_t atan_sixteenth_bam[17] = {
        0U,         42667331U,  85004756U,  126697423U, 167458907U, 207041579U,
        245243172U, 281909457U, 316933406U, 350251643U, 381839095U, 411702716U,
        439875013U, 466407904U, 491367227U, 514828063U, 536870912U};
    uint32_t above = 0U;
    const uint32_t sixteenth = count_sixteenths(smaller, larger, &above);
    const uint32_t rest_q32 =
        sixteenth_q32(above, ((uint64_t)larger * 16U) + ((uint64_t)sixteenth * smaller));
    const uint32_t square_q32 = multiply_short_q32(rest_q32, rest_q32);
    uint32_t sum = 0x33333333U - multiply_short_q32(square_q32, 0x24924925U);
    sum = 0x55555555U - multiply_short_q32(square_q32, sum);
    const uint64_t whole = ONE_Q32 - multiply_short_q32(square_q32, sum);
    const uint32_t radians_q32 = (uint32_t)multiply_q32(rest_q32, whole);
    return atan_sixteenth_bam[sixteenth] + multiply_short_q32(radians_q32, BAM_PER_RADIAN);
}

int32_t fixed_atan2_bam(int64_t y, int64_t x)
{
    uint32_t angle = 0U;
    const uint64_t size_x = magnitude(x);
    const uint64_t size_y = magnitude(y);
    const bool is_steep = size_y > size_x;
    const uint64_t larger = is_steep ? size_y : size_x;
    const uint64_t smaller = is_steep ? size_x : size_y;
    if (larger != 0U) {
        const uint32_t length = bit_length(larger);
        angle = octant_angle((uint32_t)to_31_bits(smaller, length),
                             (uint32_t)to_31_bits(larger, length));
    }
    if (is_steep) {
        angle = 0x40000000U - angle;
    }
    if (x < 0) {
        angle = 0x80000000U - angle;
    }
    if (y < 0) {
        angle = 0U - angle;
    }
    return signed_bits(angle);
}

/* 1 / square root of `value_q32` of a quarter to one, q30, within 6e-8: Newton's method from a
 * straight line that is at most 9 % off, of which each step leaves one and a half times the square.
 */
static uint32_t reciprocal_root_q30(uint32_t value_q32)
{
    uint32_t root_q30 = 2290000000U - multiply_short_q32(value_q32, 1310000000U);
    for (uint32_t i = 0U; i < 3U; i++) {
        const uint32_t square_q28 = multiply_short_q32(root_q30, root_q30);
        const uint32_t rest_q28 = 0x30000000U - multiply_short_q32(square_q28, value_q32);
        root_q30 = (uint32_t)(((uint64_t)root_q30 * rest_q28) >> 29U);
    }
    return root_q30;
}

/* The root of a number of which one of the two highest bits is set. The first root is surely too
 * small, by less than 300; so is the second, which the reciprocal gives without a division, by less
 * than 3; the loop does the rest. */
static uint32_t root_of_wide(uint64_t value)
{
    const uint32_t upper = (uint32_t)(value >> 32U);
    const uint64_t reciprocal_q30 = reciprocal_root_q30(upper);
    uint64_t root = (((uint64_t)upper * reciprocal_q30) >> 30U) - 32U;
    uint64_t rest = value - (root * root);
    root += (((rest >> 10U) * reciprocal_q30) >> 53U) - 1U;
    rest = value - (root * root);
    while (rest > (2U * root)) {
        rest -= (2U * root) + 1U;
        root++;
    }
    return (uint32_t)root;
}

uint32_t fixed_square_root(uint64_t value)
{
    uint64_t wide = value;
    uint32_t shift = 0U;
    if (value == 0U) {
        return 0U;
    }
    shift += lift(&wide, 32U);
    shift += lift(&wide, 16U);
    shift += lift(&wide, 8U);
    shift += lift(&wide, 4U);
    shift += lift(&wide, 2U);
    return root_of_wide(wide) >> (shift / 2U);
}

int32_t fixed_multiply_q30(int32_t a, int32_t b_q30)
{
    return fixed_saturate(fixed_shift_rounded((int64_t)a * b_q30, 30U));
}

/* A vector scaled so that its widest coordinate has 31 bits. */
typedef struct {
    uint64_t size[3];
    uint32_t length; /* Bits of the widest coordinate before. */
    uint64_t norm;   /* Norm of the scaled vector. */
} scaled_t;

static void scale(const int64_t vector[3], scaled_t *scaled)
{
    uint64_t sum = 0U;
    const uint64_t widest = magnitude(vector[0]) | magnitude(vector[1]) | magnitude(vector[2]);
    scaled->length = bit_length(widest);
    for (uint32_t i = 0U; i < 3U; i++) {
        scaled->size[i] = to_31_bits(magnitude(vector[i]), scaled->length);
        sum += scaled->size[i] * scaled->size[i];
    }
    scaled->norm = fixed_square_root(sum);
}

static int64_t length_of(const scaled_t *scaled)
{
    if (scaled->length > 31U) {
        const uint32_t excess = scaled->length - 31U;
        const uint64_t size = scaled->norm << excess;
        return (int64_t)size;
    }
    const uint32_t lack = 31U - scaled->length;
    const uint64_t one = 1ULL << lack;
    const uint64_t size = (scaled->norm + (one / 2U)) >> lack;
    return (int64_t)size;
}

int64_t fixed_length(const int64_t vector[3])
{
    scaled_t scaled;
    scale(vector, &scaled);
    return length_of(&scaled);
}

int64_t fixed_normalise(const int64_t vector[3], int32_t unit_q30[3])
{
    scaled_t scaled;
    scale(vector, &scaled);
    for (uint32_t i = 0U; i < 3U; i++) {
        const uint64_t size =
            (scaled.norm == 0U)
                ? 0U
                : fixed_divide((scaled.size[i] << 30U) + (scaled.norm / 2U), scaled.norm);
        unit_q30[i] = (int32_t)with_sign(size, vector[i] < 0);
    }
    return length_of(&scaled);
}

int32_t fixed_wrap_bam(int64_t value)
{
    const uint64_t bits = (uint64_t)value & 0xFFFFFFFFULL;
    return signed_bits((uint32_t)bits);
}

int64_t fixed_divide_signed(int64_t value, int64_t divisor)
{
    return with_sign(fixed_divide(magnitude(value), (uint64_t)divisor), value < 0);
}

int64_t fixed_divide_rounded(int64_t numerator, int64_t denominator)
{
    static const char contract_module[] = "fixed";
    REQUIRE(100U, denominator > 0);
    const uint64_t size = magnitude(numerator);
    const uint64_t divisor = (uint64_t)denominator;
    if (size == 0U) {
        return 0;
    }
    uint64_t quotient = fixed_divide(size, divisor);
    const uint64_t rest = size - (quotient * divisor);
    if (rest >= (divisor - rest)) {
        quotient++;
    }
    return with_sign(quotient, numerator < 0);
}
