/* SPDX-License-Identifier: Apache-2.0 */
#include "oracle/replies.h"

#include <stddef.h>

const answer_t *replies_to(const controller_outputs_t *outputs, uint32_t number)
{
    uint32_t seen = 0U;
    for (uint32_t i = 0U; i < outputs->answer_count; i++) {
        const answer_t *const answer = &outputs->answers[i];
        const bool is_immediate = (answer->kind == (uint32_t)ANSWER_ACCEPTED) ||
                                  (answer->kind == (uint32_t)ANSWER_REFUSED);
        if (is_immediate && (seen == number)) {
            return answer;
        }
        seen += is_immediate ? 1U : 0U;
    }
    return NULL;
}

bool replies_accept(const controller_outputs_t *outputs, uint32_t number)
{
    const answer_t *const answer = replies_to(outputs, number);
    return (answer != NULL) && (answer->kind == (uint32_t)ANSWER_ACCEPTED);
}
