/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The sequence lock by which one process writes what many read, without waiting: the sequence is
 * odd while it is being written, 0 before the first time. Private to app/exchange.
 */
#ifndef BORESIGHT_EXCHANGE_LOCK_H
#define BORESIGHT_EXCHANGE_LOCK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define EXCHANGE_READ_TRIES 100U

/* A copy under a sequence lock races by design; word by word and atomic, no word is ever half old.
 */
static inline void exchange_store_words(void *to, const void *from, size_t size)
{
    uint32_t *words = to;
    const unsigned char *bytes = from;

    for (size_t i = 0U; i < (size / sizeof(uint32_t)); i++) {
        uint32_t word;
        (void)memcpy(&word, &bytes[i * sizeof word], sizeof word);
        __atomic_store_n(&words[i], word, __ATOMIC_RELAXED);
    }
}

static inline void exchange_load_words(void *to, const void *from, size_t size)
{
    const uint32_t *words = from;
    unsigned char *bytes = to;

    for (size_t i = 0U; i < (size / sizeof(uint32_t)); i++) {
        const uint32_t word = __atomic_load_n(&words[i], __ATOMIC_RELAXED);
        (void)memcpy(&bytes[i * sizeof word], &word, sizeof word);
    }
}

static inline void exchange_write_locked(uint32_t *sequence, void *to, const void *from,
                                         size_t size)
{
    const uint32_t before = __atomic_load_n(sequence, __ATOMIC_RELAXED) & ~1U;

    __atomic_store_n(sequence, before + 1U, __ATOMIC_RELAXED);
    __atomic_thread_fence(__ATOMIC_RELEASE);
    exchange_store_words(to, from, size);
    __atomic_store_n(sequence, before + 2U, __ATOMIC_RELEASE);
}

/** False before the first writing and when the writer was in it; `to` is then undefined. */
static inline bool exchange_read_locked(const uint32_t *sequence, void *to, const void *from,
                                        size_t size)
{
    const uint32_t before = __atomic_load_n(sequence, __ATOMIC_ACQUIRE);

    if ((before == 0U) || ((before & 1U) != 0U)) {
        return false;
    }
    exchange_load_words(to, from, size);
    __atomic_thread_fence(__ATOMIC_ACQUIRE);
    return __atomic_load_n(sequence, __ATOMIC_RELAXED) == before;
}

#endif
