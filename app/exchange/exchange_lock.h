/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The sequence lock by which one process writes what many read, without waiting: the sequence is
 * odd while it is being written, 0 before the first time. A record of another process than control
 * is sealed as well: damage by a neighbour is not taken for its content. Private to app/exchange.
 */
#ifndef BORESIGHT_EXCHANGE_LOCK_H
#define BORESIGHT_EXCHANGE_LOCK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define EXCHANGE_READ_TRIES 100U
#define EXCHANGE_SEAL UINT32_C(0x811C9DC5) /**< Start of the check; FNV-1a has it from here. */
#define EXCHANGE_SEAL_PRIME UINT32_C(0x01000193)

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

/**
 * The seal of a record: a sequence lock, and a check of the bytes.
 *
 * @satisfies SWR-EXCH-022
 */
typedef struct {
    uint32_t sequence;
    uint32_t check;
} exchange_seal_t;

/** FNV-1a by words, of whole words. */
static inline uint32_t exchange_check(uint32_t start, const void *from, size_t size)
{
    const unsigned char *bytes = from;
    uint32_t check = EXCHANGE_SEAL ^ start;

    for (size_t i = 0U; i < (size / sizeof(uint32_t)); i++) {
        uint32_t word;
        (void)memcpy(&word, &bytes[i * sizeof word], sizeof word);
        check = (check ^ word) * EXCHANGE_SEAL_PRIME;
    }
    return check;
}

static inline void exchange_write_sealed(exchange_seal_t *seal, void *to, const void *from,
                                         size_t size)
{
    const uint32_t before = __atomic_load_n(&seal->sequence, __ATOMIC_RELAXED) & ~1U;
    const uint32_t after = (before != (UINT32_MAX - 1U)) ? (before + 2U) : 2U; /* Never 0. */

    __atomic_store_n(&seal->sequence, before + 1U, __ATOMIC_RELAXED);
    __atomic_thread_fence(__ATOMIC_RELEASE);
    __atomic_store_n(&seal->check, exchange_check(0U, from, size), __ATOMIC_RELAXED);
    exchange_store_words(to, from, size);
    __atomic_store_n(&seal->sequence, after, __ATOMIC_RELEASE);
}

/** As exchange_read_locked(); false of a record that was damaged, too. */
static inline bool exchange_read_sealed(const exchange_seal_t *seal, void *to, const void *from,
                                        size_t size)
{
    const uint32_t before = __atomic_load_n(&seal->sequence, __ATOMIC_ACQUIRE);
    const uint32_t check = __atomic_load_n(&seal->check, __ATOMIC_RELAXED);

    return exchange_read_locked(&seal->sequence, to, from, size) &&
           (__atomic_load_n(&seal->sequence, __ATOMIC_RELAXED) == before) &&
           (check == exchange_check(0U, to, size));
}

/** A number that carries its own check. */
static inline uint64_t exchange_sealed(uint32_t number)
{
    return ((uint64_t)(number ^ EXCHANGE_SEAL) << 32U) | number;
}

/** 0 when it is none: never written, or damaged. */
static inline uint32_t exchange_unsealed(uint64_t word)
{
    const uint32_t number = (uint32_t)word;

    return (word == exchange_sealed(number)) ? number : 0U;
}

static inline void exchange_store_number(uint64_t *to, uint32_t number)
{
    __atomic_store_n(to, exchange_sealed(number), __ATOMIC_RELEASE);
}

static inline uint32_t exchange_load_number(const uint64_t *from)
{
    return exchange_unsealed(__atomic_load_n(from, __ATOMIC_ACQUIRE));
}

#endif
