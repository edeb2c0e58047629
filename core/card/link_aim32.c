/* SPDX-License-Identifier: Apache-2.0 */
#include "card/link_aim32.h"

#include "card/aim32_frame.h"

#include <stddef.h>

static void take(link_t *self, uint32_t slot, const card_report_t *read)
{
    const card_report_t before = self->report;
    card_report_t *const report = &self->report;

    *report = *read;
    report->slot = slot;
    report->card_type = self->sealed.card_type;
    report->firmware = self->sealed.firmware;
    report->heartbeat = before.heartbeat + 1U;
    report->time_us = before.time_us + self->reported_us;
    report->applied = self->sealed.sent_before;
    report->edges = CARD_EDGES_UNKNOWN;
    report->last_edge_us =
        (read->encoder_count == before.encoder_count) ? before.last_edge_us : report->time_us;
    self->sealed.has_report = 1U;
    self->is_fresh = 1U;
}

static void receive(link_t *self, uint32_t slot, const uint8_t *bytes, uint32_t sampled_us,
                    uint32_t elapsed_us)
{
    card_report_t read = {.slot = slot};

    self->is_fresh = 0U;
    self->is_timed = 0U;
    self->reported_us = 0U;
    self->last_error = (uint16_t)CARD_FRAME_OK;
    if (bytes == NULL) {
        link_note_missed(self);
        return;
    }
    const card_frame_result_t result = aim32_frame_decode_report(bytes, &read);
    self->last_error = (uint16_t)result;
    if (result == CARD_FRAME_OK) {
        self->reported_us = link_measured_us(self, sampled_us, elapsed_us);
        self->sampled_us = sampled_us;
        take(self, slot, &read);
    } else {
        self->sealed.frame_errors += (self->sealed.frame_errors < UINT32_MAX) ? 1U : 0U;
    }
}

void link_aim32_step(link_t *self, uint32_t slot, const uint8_t *bytes,
                     const card_samples_t *samples, uint32_t elapsed_us)
{
    link_advance(self, elapsed_us);
    receive(self, slot, bytes, samples->sampled_us[slot], elapsed_us);
    link_judge(self, self->is_fresh != 0U);
}
