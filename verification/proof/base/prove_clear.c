/* SPDX-License-Identifier: Apache-2.0 */
/* Memory that is cleared, of every length up to 212 bytes: each loop of clear_words() goes round.
 */
#include "prove.h"

#include "base/clear.h"

#define MOST 212U

static uint8_t bytes[MOST + 4U];

void prove_SWR_CARD_004_cleared_memory_is_zero_and_no_more_is(void)
{
    uint8_t any[sizeof bytes];
    uint32_t words;
    uint32_t index;
    assume(words <= (MOST / 4U));
    assume(index < sizeof bytes);
    (void)memcpy(bytes, any, sizeof bytes);

    clear_words(bytes, words * 4U);

    PROVE(IMPLIES(index < (words * 4U), bytes[index] == 0U),
          "SWR-CARD-004: cleared memory is zero");
    PROVE(IMPLIES(index >= (words * 4U), bytes[index] == any[index]), "SWR-CARD-004: no more is");
    POSSIBLE(bytes[index] != 0U, "what was not cleared");
}
