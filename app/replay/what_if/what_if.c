/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/what_if/what_if.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Inputs that may be changed. */
static const struct {
    const char *name;
    size_t offset;
    uint32_t most;
} inputs[] = {
    {"elapsed_us", offsetof(controller_inputs_t, elapsed_us), UINT32_MAX},
    {"late_stage", offsetof(controller_inputs_t, late_stage), UINT32_MAX},
    {"pedal_a", offsetof(controller_inputs_t, pedal_a), 1U},
    {"pedal_b", offsetof(controller_inputs_t, pedal_b), 1U},
    {"estop_open", offsetof(controller_inputs_t, estop_open), 1U},
    {"scanner_active", offsetof(controller_inputs_t, scanner_active), 1U},
    {"has_button", offsetof(controller_inputs_t, has_button), 1U},
    {"confirm_pressed", offsetof(controller_inputs_t, confirm_pressed), 1U},
    {"dose_reached", offsetof(controller_inputs_t, dose_reached), 1U},
    {"treatment_stopped", offsetof(controller_inputs_t, treatment_stopped), 1U},
    {"unread", offsetof(controller_inputs_t, unread), UINT32_MAX},
    {"silent_sources", offsetof(controller_inputs_t, silent_sources), UINT32_MAX},
    {"unfit", offsetof(controller_inputs_t, unfit), UINT32_MAX},
    {"lacks_black_box", offsetof(controller_inputs_t, lacks_black_box), 1U},
    {"frames_received", offsetof(controller_inputs_t, frames_received), CARD_EVERY_SLOT},
    {"command_count", offsetof(controller_inputs_t, command_count), 0U},
};
#define INPUTS (sizeof inputs / sizeof inputs[0])

/* A decimal or, behind 0x, hexadecimal number of 32 bits with nothing but `end` behind it; sets
 * `*behind` behind that. */
static bool read_number(const char *text, char end, uint32_t *number, const char **behind)
{
    char *stop = NULL;

    errno = 0;
    const unsigned long long value =
        strtoull(text, &stop, (strncmp(text, "0x", 2U) == 0) ? 16 : 10);
    if ((text[0] < '0') || (text[0] > '9') || (errno != 0) || (value > UINT32_MAX) ||
        (*stop != end)) {
        return false;
    }
    *number = (uint32_t)value;
    *behind = (end == '\0') ? stop : (stop + 1);
    return true;
}

bool what_if_read_cycles(what_if_t *self, const char *text)
{
    const char *behind = text;

    if (read_number(text, '\0', &self->first, &behind)) {
        self->last = UINT32_MAX;
        return true;
    }
    return read_number(text, '-', &self->first, &behind) &&
           read_number(behind, '\0', &self->last, &behind) && (self->first <= self->last);
}

static size_t find_input(const char *text)
{
    const size_t length = strcspn(text, "=");
    size_t place = 0U;

    while ((place < INPUTS) && ((strlen(inputs[place].name) != length) ||
                                (strncmp(inputs[place].name, text, length) != 0))) {
        place++;
    }
    return place;
}

static void list_inputs(char *text, size_t size)
{
    size_t used = strlen(text);

    for (size_t i = 0U; (i < INPUTS) && (used < size); i++) {
        used += (size_t)snprintf(&text[used], size - used, "%s%s", (i > 0U) ? ", " : "",
                                 inputs[i].name);
    }
    if (used < size) {
        (void)snprintf(&text[used], size - used, ".");
    }
}

bool what_if_add(what_if_t *self, const char *text, char *error, size_t size)
{
    const size_t place = find_input(text);
    const char *value = strchr(text, '=');
    what_if_change_t change;

    if ((place == INPUTS) || (value == NULL)) {
        (void)snprintf(error, size, "\"%s\" changes no input; give INPUT=VALUE, with one of ",
                       text);
        list_inputs(error, size);
        return false;
    }
    if (!read_number(value + 1, '\0', &change.value, &value) ||
        (change.value > inputs[place].most)) {
        (void)snprintf(error, size, "\"%s\" is no value of it; give a number from 0 to %lu.", text,
                       (unsigned long)inputs[place].most);
        return false;
    }
    if (self->count == WHAT_IF_CHANGES) {
        (void)snprintf(error, size, "More than %u inputs cannot be changed.", WHAT_IF_CHANGES);
        return false;
    }
    change.offset = inputs[place].offset;
    self->changes[self->count] = change;
    self->count++;
    return true;
}

static void print(void *to, const char *line)
{
    (void)to;
    (void)puts(line);
}

void what_if_begin(what_if_t *self, const robot_t *robot)
{
    self->robot = robot;
    difference_init(&self->difference, robot, print, NULL);
}

void what_if_prepare(what_if_t *self, const replay_t *replay, const cycle_record_t *record)
{
    const bool is_next = replay->is_running && (record->cycle == replay->next_cycle) &&
                         (record->kind == (uint32_t)CYCLE_RECORD_CYCLE);

    if (is_next && !self->has_begun && (record->cycle >= self->first) &&
        (record->cycle <= self->last)) {
        self->controller = replay->controller;
        self->has_begun = true;
    }
}

static void change_inputs(what_if_t *self, const cycle_record_t *record)
{
    self->inputs = record->body.cycle.inputs;
    if ((record->cycle < self->first) || (record->cycle > self->last)) {
        return;
    }
    for (uint32_t i = 0U; i < self->count; i++) {
        (void)memcpy((uint8_t *)&self->inputs + self->changes[i].offset, &self->changes[i].value,
                     sizeof self->changes[i].value);
    }
}

void what_if_take(what_if_t *self, const replay_t *replay, const cycle_record_t *record)
{
    if (!self->has_begun || self->has_ended || (record->kind != (uint32_t)CYCLE_RECORD_CYCLE)) {
        return;
    }
    if (!replay->is_running) {
        self->has_ended = true;
        return;
    }
    change_inputs(self, record);
    self->cycle = record->cycle;
    controller_step(&self->controller, self->robot, &self->inputs, &self->outputs);
    self->compared++;
    if (memcmp(&self->outputs, &replay->outputs, sizeof self->outputs) != 0) {
        self->different++;
        difference_report(&self->difference, record->cycle, &replay->outputs, &self->outputs);
    }
}

bool what_if_end(const what_if_t *self)
{
    if (!self->has_begun) {
        (void)printf("No cycle of this recording is changed: it has none of them, or none before "
                     "them has the state.\n");
        return false;
    }
    if (self->different == 0U) {
        (void)printf("Nothing differs in %llu cycles.\n", (unsigned long long)self->compared);
    } else {
        (void)printf("%llu of %llu cycles differ. What the cards report is as it was recorded: "
                     "nothing answered to the change.\n",
                     (unsigned long long)self->different, (unsigned long long)self->compared);
    }
    if (self->has_ended) {
        (void)printf("Cycles are missing after cycle %lu; what follows was not compared.\n",
                     (unsigned long)self->cycle);
    }
    return true;
}
