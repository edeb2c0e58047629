/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A process that damages what every process may write in the exchange: random words, parts of words
 * and extremes in each of its fields in turn, until its time is over or it is asked to end.
 *
 *     neighbour INSTANCE MILLISECONDS SEED
 */
#include "exchange/exchange.h"
#include "exchange/exchange_segment.h"
#include "interface/segment_fields.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define PAUSE_NS 100000L
#define WRITES_AT_ONCE 10U

typedef struct {
    const char *name;
    size_t place;
    size_t size;
} field_t;

#define FIELD(name, count)                                                                         \
    {#name, offsetof(segment_others_t, name), sizeof(((segment_others_t *)NULL)->name)},
static const field_t fields[] = {SEGMENT_OTHERS_FIELDS(FIELD)};
#define FIELDS (sizeof fields / sizeof fields[0])

static const uint32_t extremes[] = {0U, 1U, 0x80000000U, UINT32_MAX};

static uint64_t chance;

static uint32_t random_word(void)
{
    chance ^= chance << 13U;
    chance ^= chance >> 7U;
    chance ^= chance << 17U;
    return (uint32_t)(chance >> 16U);
}

static uint32_t damaged(uint32_t word)
{
    switch (random_word() % 4U) {
    case 0U:
        return random_word();
    case 1U:
        return extremes[random_word() % (sizeof extremes / sizeof extremes[0])];
    case 2U:
        return word + (random_word() % 64U);
    default:
        return word ^ (0xFFU & random_word());
    }
}

static void damage(exchange_t *exchange)
{
    const field_t *field = &fields[random_word() % FIELDS];
    uint32_t *words =
        (uint32_t *)(void *)((unsigned char *)&exchange->segment->others + field->place);
    uint32_t *word = &words[random_word() % (field->size / sizeof *words)];

    __atomic_store_n(word, damaged(__atomic_load_n(word, __ATOMIC_RELAXED)), __ATOMIC_RELAXED);
}

static uint64_t now_ms(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((uint64_t)now.tv_sec * 1000U) + ((uint64_t)now.tv_nsec / 1000000U);
}

int main(int count, char **arguments)
{
    const struct timespec pause = {.tv_sec = 0, .tv_nsec = PAUSE_NS};
    char error[256];

    if (count != 4) {
        (void)fprintf(stderr, "usage: neighbour INSTANCE MILLISECONDS SEED\n");
        return 2;
    }
    exchange_t *const exchange = exchange_open(arguments[1], error, sizeof error);
    if (exchange == NULL) {
        (void)fprintf(stderr, "neighbour: %s\n", error);
        return 1;
    }
    exchange_protect(exchange, EXCHANGE_IGTL);
    chance = UINT64_C(88172645463325252) ^ strtoull(arguments[3], NULL, 10);
    const uint64_t end_ms = now_ms() + strtoull(arguments[2], NULL, 10);
    uint32_t writes = 0U;
    while (now_ms() < end_ms) {
        for (uint32_t i = 0U; i < WRITES_AT_ONCE; i++) {
            damage(exchange);
            writes++;
        }
        (void)nanosleep(&pause, NULL);
    }
    (void)printf("%u\n", (unsigned)writes);
    exchange_close(exchange);
    return 0;
}
