/* SPDX-License-Identifier: Apache-2.0 */
/** @file Contract of core/base/clear.h, in place of it: the bytes are the caller's, and zero
 * afterwards. */
#ifndef BORESIGHT_CLEAR_H
#define BORESIGHT_CLEAR_H

#include <stddef.h>
#include <stdint.h>

static inline void clear_words(uint8_t *bytes, size_t length)
{
    __CPROVER_assert((length % 4U) == 0U, "contract of clear_words: whole words");
    __CPROVER_array_set(bytes, 0U);
}

static inline void clear_aligned_words(uint8_t *bytes, size_t length)
{
    clear_words(bytes, length);
}

#endif
