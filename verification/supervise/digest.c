/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/digest.h"

#include <stddef.h>

#define FNV_BASIS UINT64_C(0xCBF29CE484222325)
#define FNV_PRIME UINT64_C(0x00000100000001B3)

void digest_begin(digest_t *self)
{
    *self = (digest_t){.hash = FNV_BASIS};
}

static void add(digest_t *self, const void *bytes, size_t size)
{
    const uint8_t *const all = bytes;
    for (size_t i = 0U; i < size; i++) {
        self->hash = (self->hash ^ all[i]) * FNV_PRIME;
    }
}

static void add_answer(digest_t *self, const answer_t *answer)
{
    const uint32_t words[] = {answer->id,   answer->source,     answer->command,
                              answer->kind, answer->status,     answer->is_final,
                              answer->axis, answer->is_maximum, answer->workphase};
    add(self, words, sizeof words);
    add(self, &answer->pose, sizeof answer->pose);
}

void digest_add(digest_t *self, const controller_outputs_t *outputs)
{
    add(self, &outputs->frames_to_send, sizeof outputs->frames_to_send);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (((outputs->frames_to_send >> slot) & 1U) != 0U) {
            add(self, outputs->frames[slot], sizeof outputs->frames[slot]);
        }
    }
    add(self, &outputs->answer_count, sizeof outputs->answer_count);
    for (uint32_t i = 0U; i < outputs->answer_count; i++) {
        add_answer(self, &outputs->answers[i]);
    }
    add(self, &outputs->event_count, sizeof outputs->event_count);
    add(self, outputs->events, outputs->event_count * sizeof outputs->events[0]);
    self->cycles++;
}
