/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: so many bytes are zero afterwards, and none beside them. */
#include "base/clear.h"

#include "unity.h"

#define BYTES 256U
#define MARGIN 8U

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_CORE_002_every_number_of_words_is_cleared_and_none_beside_them(void)
{
    uint8_t bytes[MARGIN + BYTES + MARGIN];
    for (size_t length = 0U; length <= BYTES; length += 4U) {
        (void)memset(bytes, 0xA5, sizeof bytes);
        clear_words(&bytes[MARGIN], length);
        for (size_t i = 0U; i < sizeof bytes; i++) {
            const uint8_t expected = ((i >= MARGIN) && (i < (MARGIN + length))) ? 0U : 0xA5U;
            TEST_ASSERT_EQUAL_HEX8(expected, bytes[i]);
        }
    }
}
