/* SPDX-License-Identifier: Apache-2.0 */
/** @file Contract of core/base/clear.h for Eva, in place of it: the bytes are the caller's, and
 * zero afterwards. Of memset() Eva knows the range that is written; of a loop over it, it does not.
 */
#ifndef BORESIGHT_CLEAR_H
#define BORESIGHT_CLEAR_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

static inline void clear_words(uint8_t *bytes, size_t length)
{
    (void)memset(bytes, 0, length);
}

static inline void clear_aligned_words(uint8_t *bytes, size_t length)
{
    clear_words(bytes, length);
}

#endif
