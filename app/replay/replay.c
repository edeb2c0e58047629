/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/replay.h"

#include <stdio.h>
#include <string.h>

/* A part of the outputs that consists of equal elements. */
typedef struct {
    const char *name;
    const char *element;
    size_t offset;
    size_t size;
    size_t element_size;
} area_t;

static const area_t areas[] = {
    {"counts", "word", 0U, offsetof(controller_outputs_t, answers), sizeof(uint32_t)},
    {"answers", "answer", offsetof(controller_outputs_t, answers),
     sizeof(((controller_outputs_t *)0)->answers), sizeof(answer_t)},
    {"events", "event", offsetof(controller_outputs_t, events),
     sizeof(((controller_outputs_t *)0)->events), sizeof(event_t)},
    {"snapshot", "snapshot", offsetof(controller_outputs_t, snapshot), sizeof(snapshot_t),
     sizeof(snapshot_t)},
    {"frames", "slot", offsetof(controller_outputs_t, frames),
     sizeof(((controller_outputs_t *)0)->frames), CARD_FRAME_BYTES},
};

void replay_init(replay_t *self)
{
    (void)memset(self, 0, sizeof *self);
}

static void restore(replay_t *self, const cycle_record_t *record)
{
    (void)memcpy(&self->controller, record->body.checkpoint, sizeof self->controller);
    self->next_cycle = record->cycle;
    self->is_running = true;
    self->checkpoints++;
}

bool replay_take(replay_t *self, const robot_t *robot, const cycle_record_t *record)
{
    if (record->kind == CYCLE_RECORD_CHECKPOINT) {
        restore(self, record);
        return true;
    }
    if (self->is_running && (record->cycle != self->next_cycle)) {
        self->is_running = false;
        self->gaps++;
    }
    if (!self->is_running) {
        self->unreplayed++;
        return true;
    }
    controller_step(&self->controller, robot, &record->body.cycle.inputs, &self->outputs);
    self->next_cycle = record->cycle + 1U;
    if (memcmp(&self->outputs, &record->body.cycle.outputs, sizeof self->outputs) != 0) {
        return false;
    }
    self->replayed++;
    return true;
}

void replay_difference(const replay_t *self, const cycle_record_t *record, char *text, size_t size)
{
    const uint8_t *recorded = (const uint8_t *)&record->body.cycle.outputs;
    const uint8_t *replayed = (const uint8_t *)&self->outputs;
    size_t offset = 0U;
    size_t area = 0U;

    while ((offset < sizeof self->outputs) && (recorded[offset] == replayed[offset])) {
        offset++;
    }
    while (((area + 1U) < (sizeof areas / sizeof areas[0])) &&
           (offset >= areas[area + 1U].offset)) {
        area++;
    }
    const size_t inside = offset - areas[area].offset;
    (void)snprintf(text, size,
                   "Cycle %u differs first at byte %zu of its outputs: %s, %s %zu, byte %zu is "
                   "0x%02X, recorded 0x%02X.",
                   (unsigned)record->cycle, offset, areas[area].name, areas[area].element,
                   inside / areas[area].element_size, inside % areas[area].element_size,
                   replayed[offset], recorded[offset]);
}
