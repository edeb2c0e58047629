/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/format/cycle_code.h"

#include <string.h>

#define SEVEN_BITS 0x7FU
#define MORE 0x80U
#define NUMBER_BYTES_MAX 5U
#define HASH_BYTES 4U

/* Bytes that are being written or read. */
typedef struct {
    uint8_t *bytes;
    size_t size;
} sink_t;

typedef struct {
    const uint8_t *bytes;
    size_t size;
    size_t next;
    bool is_bad; /* It ended too early, or is no number. */
} source_t;

static void put_number(sink_t *self, uint32_t number)
{
    uint32_t rest = number;

    while (rest > SEVEN_BITS) {
        self->bytes[self->size] = (uint8_t)((rest & SEVEN_BITS) | MORE);
        self->size++;
        rest >>= 7U;
    }
    self->bytes[self->size] = (uint8_t)rest;
    self->size++;
}

static uint32_t get_byte(source_t *self)
{
    if (self->next >= self->size) {
        self->is_bad = true;
        return 0U;
    }
    self->next++;
    return self->bytes[self->next - 1U];
}

static uint32_t get_number(source_t *self)
{
    uint32_t number = 0U;

    for (uint32_t i = 0U; i < NUMBER_BYTES_MAX; i++) {
        const uint32_t byte = get_byte(self);
        number |= (byte & SEVEN_BITS) << (7U * i);
        if ((byte & MORE) == 0U) {
            return number;
        }
    }
    self->is_bad = true;
    return 0U;
}

/* Small in either direction is small. */
static uint32_t fold(uint32_t difference)
{
    return (difference << 1U) ^ (0U - (difference >> 31U));
}

static uint32_t unfold(uint32_t folded)
{
    return (folded >> 1U) ^ (0U - (folded & 1U));
}

void cycle_code_begin(cycle_code_t *self)
{
    (void)memset(self, 0, sizeof *self);
}

/* The clock of the words before the one that says the time that has passed stands still. */
static void put_changes(trend_t *trends, const uint32_t *words, sink_t *sink)
{
    uint32_t elapsed_us = 0U;
    uint32_t before = 0U;

    for (uint32_t i = 0U; i < CYCLE_WORDS_KEPT; i++) {
        uint32_t expected = 0U;
        if (!trend_take(&trends[i], words[i], elapsed_us, &expected)) {
            put_number(sink, (i + 1U) - before);
            put_number(sink, fold(words[i] - expected));
            before = i + 1U;
        }
        elapsed_us = (i == CYCLE_WORDS_ELAPSED) ? words[i] : elapsed_us;
    }
    put_number(sink, 0U);
}

static void put_all(const uint32_t *words, uint32_t count, sink_t *sink)
{
    uint32_t before = 0U;

    for (uint32_t i = 0U; i < count; i++) {
        if (words[i] != 0U) {
            put_number(sink, (i + 1U) - before);
            put_number(sink, fold(words[i]));
            before = i + 1U;
        }
    }
    put_number(sink, 0U);
}

static void put_hash(sink_t *self, uint32_t hash)
{
    for (uint32_t i = 0U; i < HASH_BYTES; i++) {
        self->bytes[self->size] = (uint8_t)(hash >> (8U * i));
        self->size++;
    }
}

static void put_proof(const proof_t *proof, sink_t *sink)
{
    put_number(sink, proof->surprises);
    for (uint32_t part = 0U; part < PROOF_PARTS; part++) {
        if (((proof->surprises >> part) & 1U) != 0U) {
            put_hash(sink, proof->hashes[part]);
        }
    }
}

size_t cycle_code_encode(cycle_code_t *self, prover_t *prover, bool is_whole,
                         const recorded_cycle_t *cycle, uint8_t *bytes)
{
    uint32_t kept[CYCLE_WORDS_KEPT];
    uint32_t checked[CYCLE_WORDS_CHECKED];
    proof_t proof;
    sink_t sink = {.bytes = bytes, .size = 1U};

    cycle_words_of_kept(cycle, kept);
    cycle_words_of_checked(&cycle->outputs, checked);
    if (is_whole) {
        prover_begin(prover);
    }
    prover_take(prover, cycle->inputs.elapsed_us, checked, &proof);
    put_changes(self->trends, kept, &sink);
    if (is_whole) {
        bytes[0] = (uint8_t)CYCLE_WHOLE;
        put_all(checked, CYCLE_WORDS_CHECKED, &sink);
        return sink.size;
    }
    if ((sink.size == 2U) && (proof.surprises == 0U)) {
        bytes[0] = (uint8_t)CYCLE_QUIET;
        return 1U;
    }
    bytes[0] = (uint8_t)CYCLE_CHANGES;
    put_proof(&proof, &sink);
    return sink.size;
}

/* The word, from 1, that changes next; 0 after the last. */
static uint32_t get_place(source_t *source, uint32_t before, uint32_t count)
{
    const uint32_t way = get_number(source);

    if ((way == 0U) || source->is_bad) {
        return 0U;
    }
    if (way > (count - before)) {
        source->is_bad = true;
        return 0U;
    }
    return before + way;
}

/* Without a source all is as expected. */
static void get_changes(trend_t *trends, uint32_t *words, source_t *source)
{
    uint32_t elapsed_us = 0U;
    uint32_t place = (source != NULL) ? get_place(source, 0U, CYCLE_WORDS_KEPT) : 0U;

    for (uint32_t i = 0U; i < CYCLE_WORDS_KEPT; i++) {
        uint32_t expected = 0U;
        words[i] = trend_expected(&trends[i], elapsed_us);
        if (place == (i + 1U)) {
            words[i] += unfold(get_number(source));
            place = get_place(source, place, CYCLE_WORDS_KEPT);
        }
        (void)trend_take(&trends[i], words[i], elapsed_us, &expected);
        elapsed_us = (i == CYCLE_WORDS_ELAPSED) ? words[i] : elapsed_us;
    }
}

static void get_all(uint32_t *words, uint32_t count, source_t *source)
{
    uint32_t place = get_place(source, 0U, count);

    (void)memset(words, 0, count * sizeof *words);
    while (place != 0U) {
        words[place - 1U] = unfold(get_number(source));
        place = get_place(source, place, count);
    }
}

static uint32_t get_hash(source_t *self)
{
    uint32_t hash = 0U;

    for (uint32_t i = 0U; i < HASH_BYTES; i++) {
        hash |= get_byte(self) << (8U * i);
    }
    return hash;
}

static void get_proof(proof_t *proof, source_t *source)
{
    proof->surprises = get_number(source);
    for (uint32_t part = 0U; part < PROOF_PARTS; part++) {
        if (((proof->surprises >> part) & 1U) != 0U) {
            proof->hashes[part] = get_hash(source);
        }
    }
}

size_t cycle_code_decode(cycle_code_t *self, const uint8_t *bytes, size_t size,
                         recorded_cycle_t *cycle, cycle_known_t *known)
{
    uint32_t kept[CYCLE_WORDS_KEPT];
    uint32_t checked[CYCLE_WORDS_CHECKED];
    source_t source = {.bytes = bytes, .size = size, .next = 0U, .is_bad = false};
    const uint32_t kind = get_byte(&source);

    (void)memset(known, 0, sizeof *known);
    (void)memset(&cycle->outputs, 0, sizeof cycle->outputs);
    if (kind > (uint32_t)CYCLE_WHOLE) {
        return 0U;
    }
    get_changes(self->trends, kept, (kind == (uint32_t)CYCLE_QUIET) ? NULL : &source);
    cycle_words_to_kept(kept, cycle);
    if (kind == (uint32_t)CYCLE_CHANGES) {
        get_proof(&known->proof, &source);
    }
    if (kind == (uint32_t)CYCLE_WHOLE) {
        known->is_whole = true;
        get_all(checked, CYCLE_WORDS_CHECKED, &source);
        cycle_words_to_checked(checked, &cycle->outputs);
    }
    return source.is_bad ? 0U : source.next;
}
