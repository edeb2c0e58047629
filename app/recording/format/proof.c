/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/format/proof.h"

#include "base/crc.h"

#include <string.h>

void prover_begin(prover_t *self)
{
    (void)memset(self, 0, sizeof *self);
}

/* The words of a part follow those of the part before it. */
static uint32_t part_size(uint32_t part)
{
    return (part == PROOF_SNAPSHOT) ? (uint32_t)CYCLE_WORDS_SNAPSHOT : CYCLE_WORDS_FRAME;
}

/* Takes a part. True when every word of it is as expected. */
static bool take_part(trend_t *trends, const uint32_t *words, uint32_t size, uint32_t elapsed_us,
                      proof_surprise_t *surprise)
{
    bool is_expected = true;

    for (uint32_t i = 0U; i < size; i++) {
        uint32_t expected = 0U;
        if (!trend_take(&trends[i], words[i], elapsed_us, &expected) && is_expected) {
            *surprise = (proof_surprise_t){.word = i, .expected = expected};
            is_expected = false;
        }
    }
    return is_expected;
}

/* Turned on before it takes the next words: two that differ alike do not cancel each other. */
static uint32_t hash_part(uint32_t before, const uint32_t *words, uint32_t size)
{
    return ((before << 1U) | (before >> 31U)) ^
           crc32c((const uint8_t *)words, size * sizeof(uint32_t));
}

void prover_take(prover_t *self, uint32_t elapsed_us, const uint32_t words[CYCLE_WORDS_CHECKED],
                 proof_t *proof)
{
    uint32_t first = 0U;

    *proof = (proof_t){.surprises = 0U};
    for (uint32_t part = 0U; part < PROOF_PARTS; part++) {
        const uint32_t size = part_size(part);
        if (!take_part(&self->trends[first], &words[first], size, elapsed_us,
                       &self->surprises[part])) {
            proof->surprises |= 1U << part;
            self->hashes[part] = hash_part(self->hashes[part], &words[first], size);
            proof->hashes[part] = self->hashes[part];
        }
        first += size;
    }
}

uint32_t proof_difference(const proof_t *self, const proof_t *other)
{
    uint32_t part = 0U;

    while ((part < PROOF_PARTS) && (self->hashes[part] == other->hashes[part]) &&
           ((((self->surprises ^ other->surprises) >> part) & 1U) == 0U)) {
        part++;
    }
    return part;
}
