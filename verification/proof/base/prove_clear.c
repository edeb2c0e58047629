/* SPDX-License-Identifier: Apache-2.0 */
/* Memory that is cleared, of every length up to 148 bytes: each loop of clear_words() goes round.
 */
#include "prove.h"

#include "base/clear.h"

#define MOST 148U

static uint8_t bytes[MOST + 4U];

static void prove_length(uint32_t length)
{
    uint8_t any[sizeof bytes];
    uint32_t index;
    assume(index < sizeof bytes);
    (void)memcpy(bytes, any, sizeof bytes);

    clear_words(bytes, length);

    PROVE(IMPLIES(index < length, bytes[index] == 0U), "SWR-CARD-004: cleared memory is zero");
    PROVE(IMPLIES(index >= length, bytes[index] == any[index]), "SWR-CARD-004: no more is");
    POSSIBLE(bytes[index] != 0U, "what was not cleared");
}

void prove_SWR_CARD_004_cleared_memory_is_zero_and_no_more_is(void)
{
    for (uint32_t length = 0U; length <= MOST; length += 4U) {
        prove_length(length);
    }
}
