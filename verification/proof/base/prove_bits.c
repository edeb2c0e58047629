/* SPDX-License-Identifier: Apache-2.0 */
/* Steps of division and root that bits decide, for base/prove_divide.c: of every number. They are
 * reached by including their source. */
#include "prove.h"

#include "base/fixed.c"

void prove_SWR_PROOF_800_a_number_is_lifted_by_its_leading_zeros(void)
{
    uint64_t before;
    uint32_t exponent;
    assume(exponent <= 5U);
    const uint32_t bits = 1U << exponent;
    uint64_t after = before;
    const uint32_t lifted = lift(&after, bits);
    const bool is_low = before < (1ULL << (64U - bits));
    PROVE(IMPLIES(is_low,
                  (lifted == bits) && (after == (before << bits)) && ((after >> bits) == before)),
          "SWR-PROOF-800: what has so many leading zeros is multiplied by their power of two");
    PROVE(IMPLIES(!is_low, (lifted == 0U) && (after == before)),
          "SWR-PROOF-800: what has fewer is kept");
    POSSIBLE(lifted == 16U, "sixteen zeros");
}

void prove_SWR_PROOF_800_a_magnitude_has_64_bits(void)
{
    int64_t value;
    const uint64_t size = magnitude(value);
    PROVE(IMPLIES(value >= 0, size == (uint64_t)value),
          "SWR-PROOF-800: that of a positive number is itself");
    PROVE(IMPLIES(value < 0,
                  (size != 0U) && (size <= (1ULL << 63U)) && ((uint64_t)value + size == 0U)),
          "SWR-PROOF-800: that of a negative number is its opposite");
    POSSIBLE(size == (1ULL << 63U), "the smallest number");
}
