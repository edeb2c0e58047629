/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/leg/mode_frame.h"

#include <string.h>

void mode_clear(mode_result_t *self)
{
    (void)memset(self->requests, 0, sizeof self->requests);
    self->progress = MODE_RUNNING;
    self->status = STATUS_OK;
    self->axis = MODE_NO_AXIS;
    self->note_count = 0U;
}

void mode_note(mode_result_t *self, event_id_t id, uint32_t axis, int32_t value)
{
    if (self->note_count < MODE_NOTES) {
        self->notes[self->note_count] = (mode_note_t){.id = id, .axis = axis, .value = value};
        self->note_count++;
    }
}

void mode_fail(mode_result_t *self, event_id_t id, uint32_t axis, int32_t value)
{
    mode_note(self, id, axis, value);
    self->progress = MODE_FAILED;
    self->status = STATUS_FAULT_PRESENT;
    self->axis = axis;
}

void mode_give_up(const mode_frame_t *frame, mode_result_t *result, status_t status)
{
    result->progress = MODE_FAILED;
    result->status = status;
    result->axis = MODE_NO_AXIS;
    mode_rest(frame, result);
}

void mode_rest(const mode_frame_t *frame, mode_result_t *result)
{
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        result->requests[i] = axis_rest(axis, frame->elapsed_us);
    }
}
