/* SPDX-License-Identifier: Apache-2.0 */
#include "digests/digest.h"

#include "base/rigid.h"

#include <stdbool.h>
#include <stddef.h>

#define FNV_BASIS UINT64_C(0xCBF29CE484222325)
#define FNV_PRIME UINT64_C(0x00000100000001B3)
#define NO_AXIS UINT32_MAX

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

static uint32_t axis_of(const answer_t *answer)
{
    const answer_form_t form = answer_form(answer);
    const bool has_axis =
        (form == ANSWER_FORM_AXIS) || (form == ANSWER_FORM_LIMIT) || (form == ANSWER_FORM_ENDED);
    return has_axis ? answer_axis(answer) : NO_AXIS;
}

static uint32_t end_of(const answer_t *answer)
{
    switch ((int)answer_form(answer)) {
    case ANSWER_FORM_LIMIT:
        return answer_as_limit(answer)->is_maximum;
    case ANSWER_FORM_SHARED_LIMIT:
        return answer_as_shared_limit(answer)->is_maximum;
    default:
        return 0U;
    }
}

static rigid_t pose_of(const answer_t *answer)
{
    rigid_t pose;
    rigid_set_identity(&pose);
    if (answer_form(answer) == ANSWER_FORM_POSE) {
        pose = answer_as_pose(answer)->pose;
    } else if (answer_form(answer) == ANSWER_FORM_POINT) {
        pose.translation = answer_as_point(answer)->point;
    } else {
        /* It has none. */
    }
    return pose;
}

static void add_answer(digest_t *self, const answer_t *answer)
{
    const bool has_sum = answer_form(answer) == ANSWER_FORM_CHECKSUM;
    const rigid_t pose = pose_of(answer);
    const uint32_t words[] = {answer->id,
                              answer->source,
                              answer->command,
                              answer->asked,
                              answer->kind,
                              answer->status,
                              answer->is_final,
                              answer->workphase,
                              axis_of(answer),
                              end_of(answer),
                              has_sum ? answer_as_checksum(answer)->checksum : 0U};
    add(self, words, sizeof words);
    add(self, &pose, sizeof pose);
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
}
