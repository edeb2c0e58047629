/* SPDX-License-Identifier: Apache-2.0 */
/* The reciprocal of base/prove_divide.c, of every number of a half to one. */
#include "exhaustive.h"

#include "base/fixed.c"

void prove_SWR_PROOF_800_a_reciprocal_is_never_too_large(void)
{
    const uint64_t one = 1ULL << 63U;
    uint32_t large = 0U;
    uint32_t small = 0U;
    uint32_t exact = 0U;
    for (uint32_t value_q32 = 0x80000000U; (value_q32 != 0U) && ((large | small) == 0U);
         value_q32++) {
        const uint64_t product = (uint64_t)reciprocal_q31(value_q32) * value_q32;
        const uint64_t missing = one - product;
        large |= (product > one) ? 1U : 0U;
        small |= (missing >= (4ULL * value_q32)) ? 1U : 0U;
        exact |= (missing < value_q32) ? 1U : 0U;
    }
    PROVE(large == 0U, "SWR-PROOF-800: with its number it makes one at most");
    PROVE(small == 0U, "SWR-PROOF-800: it is too small by 3 at most");
    POSSIBLE(exact != 0U, "one that is exact");
}
