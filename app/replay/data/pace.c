/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/data/pace.h"

#include "limits/requirement_limits.h"
#include "replay/data/series.h"
#include "replay/data/table.h"

void pace_take(pace_t *self, const recording_header_t *header, const cycle_record_t *record)
{
    if (self->has_begun) {
        const uint32_t missing = record->cycle - self->cycle - 1U;
        self->utc_us += ((uint64_t)missing * LIMIT_CYCLE_US) + record->body.cycle.inputs.elapsed_us;
    } else {
        self->utc_us = header->started_us;
    }
    self->cycle = record->cycle;
    self->has_begun = true;
}

bool pace_is_turn(pace_t *self, const snapshot_t *snapshot)
{
    const uint32_t states = series_states(fields_snapshot, snapshot);
    const bool is_turn = ((self->cycle % TABLE_CYCLES) == 0U) || (states != self->states);

    self->states = is_turn ? states : self->states;
    return is_turn;
}
