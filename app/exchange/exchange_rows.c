/* SPDX-License-Identifier: Apache-2.0 */
#include "exchange/exchange_rows.h"

#include "exchange/exchange_lock.h"
#include "exchange/exchange_segment.h"

/* A list that was refused or damaged has fewer rows than it had; any other grows. */
static bool is_another(const segment_control_t *control, uint32_t count,
                       const controller_outputs_t *outputs)
{
    bool is_begun = count < control->row_count;

    for (uint32_t i = 0U; i < outputs->answer_count; i++) {
        const answer_t *answer = &outputs->answers[i];
        is_begun = is_begun || ((answer->command == (uint32_t)COMMAND_LIST_BEGIN) &&
                                (answer->kind == (uint32_t)ANSWER_ACCEPTED));
    }
    return is_begun;
}

void exchange_publish_rows(exchange_t *self, const controller_t *controller,
                           const controller_outputs_t *outputs)
{
    segment_control_t *control = &self->segment->control;
    const trajectory_list_t *list = &controller->mode.sealed.list;
    const uint32_t count = (list->count <= LIMIT_TRAJECTORY_ROWS) ? list->count : 0U;

    if (is_another(control, count, outputs)) {
        control->row_count = 0U;
        __atomic_store_n(&control->list, control->list + 1U, __ATOMIC_RELAXED);
        __atomic_thread_fence(__ATOMIC_RELEASE);
    }
    while (control->row_count < count) {
        const uint32_t row = control->row_count;
        exchange_store_words(&control->rows[row], &controller->rows[row], sizeof control->rows[0]);
        control->row_count++;
    }
}

bool exchange_read_rows(const exchange_t *self, const cycle_record_t *checkpoint,
                        trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS])
{
    const segment_control_t *control = &self->segment->control;

    if (checkpoint->rows > LIMIT_TRAJECTORY_ROWS) {
        return false;
    }
    exchange_load_words(rows, control->rows, checkpoint->rows * sizeof control->rows[0]);
    __atomic_thread_fence(__ATOMIC_ACQUIRE);
    return (checkpoint->rows == 0U) ||
           (__atomic_load_n(&control->list, __ATOMIC_RELAXED) == checkpoint->list);
}

bool exchange_read_start(const exchange_t *self, trajectory_row_t *row)
{
    const segment_control_t *control = &self->segment->control;
    const uint32_t list = __atomic_load_n(&control->list, __ATOMIC_ACQUIRE);
    const uint32_t count = __atomic_load_n(&control->row_count, __ATOMIC_ACQUIRE);

    exchange_load_words(row, &control->rows[0], sizeof *row);
    __atomic_thread_fence(__ATOMIC_ACQUIRE);
    return (count > 0U) && (__atomic_load_n(&control->list, __ATOMIC_RELAXED) == list);
}
