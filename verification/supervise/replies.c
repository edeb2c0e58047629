/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/replies.h"

#include <stddef.h>

const answer_t *replies_to(const rig_t *rig, uint32_t number)
{
    uint32_t seen = 0U;
    for (uint32_t i = 0U; i < rig->outputs.answer_count; i++) {
        const answer_t *const answer = &rig->outputs.answers[i];
        const bool is_immediate = (answer->kind == (uint32_t)ANSWER_ACCEPTED) ||
                                  (answer->kind == (uint32_t)ANSWER_REFUSED);
        if (is_immediate && (seen == number)) {
            return answer;
        }
        seen += is_immediate ? 1U : 0U;
    }
    return NULL;
}

bool replies_accept(const rig_t *rig, uint32_t number)
{
    const answer_t *const answer = replies_to(rig, number);
    return (answer != NULL) && (answer->kind == (uint32_t)ANSWER_ACCEPTED);
}
