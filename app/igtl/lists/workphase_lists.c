/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/lists/workphase_lists.h"

#include "igtl/lists/workphase_program.h"
#include "igtl/lists/workphase_text.h"
#include "igtl/lists/workphase_trajectory.h"
#include "limits/requirement_limits.h"

#include <stddef.h>
#include <string.h>

static const workphase_list_t *const lists[WORKPHASE_LIST_COUNT] = {&workphase_trajectory,
                                                                    &workphase_program};

static bool begins(const igtl_message_t *message, const char *word)
{
    const size_t length = strlen(word);

    return (message->text_bytes >= length) && (memcmp(message->text, word, length) == 0) &&
           ((message->text_bytes == length) || (message->text[length] == ' '));
}

const workphase_list_t *workphase_lists_find(const igtl_message_t *message)
{
    for (uint32_t i = 0U; i < WORKPHASE_LIST_COUNT; i++) {
        if (begins(message, lists[i]->word)) {
            return lists[i];
        }
    }
    return NULL;
}

const workphase_list_t *workphase_lists_named(const char *name)
{
    for (uint32_t i = 0U; i < WORKPHASE_LIST_COUNT; i++) {
        if (strcmp(lists[i]->word, name) == 0) {
            return lists[i];
        }
    }
    return NULL;
}

const workphase_list_t *workphase_lists_of(uint32_t kind)
{
    for (uint32_t i = 0U; i < WORKPHASE_LIST_COUNT; i++) {
        if ((kind == (uint32_t)lists[i]->begin) || (kind == (uint32_t)lists[i]->add) ||
            (kind == (uint32_t)lists[i]->end)) {
            return lists[i];
        }
    }
    return NULL;
}

static status_t read_begin(char **text, uint32_t *sum, command_t *command)
{
    *sum = 0U;
    return workphase_text_natural(workphase_text_next(text), &command->as.list_begin.count)
               ? STATUS_OK
               : STATUS_OUT_OF_RANGE;
}

static status_t read_item(const workphase_list_t *self, const robot_t *robot, char **text,
                          uint32_t *sum, command_t *command)
{
    const uint32_t peer = command->peer;
    workphase_item_t item;
    uint32_t index = 0U;

    if (!workphase_text_natural(workphase_text_next(text), &index)) {
        return STATUS_OUT_OF_RANGE;
    }
    const status_t status = self->read_words(robot, text, &item);
    if (status == STATUS_OK) {
        *command = self->command(robot, index, &item);
        command->peer = peer;
        *sum = self->sum(*sum, &item);
    }
    return status;
}

/* END or RUN. */
static status_t read_name(char **text, uint32_t sum, command_t *command)
{
    const char *said = workphase_text_next(text);

    command->as.list.checksum = sum;
    return ((said == NULL) || workphase_text_natural(said, &command->as.list.checksum))
               ? STATUS_OK
               : STATUS_OUT_OF_RANGE;
}

static status_t read_words(const workphase_list_t *self, const robot_t *robot, char *text,
                           uint32_t *sum, command_t *command)
{
    const char *what = workphase_text_next(&text);
    status_t status = STATUS_UNKNOWN_COMMAND;

    if (what == NULL) {
        return status;
    }
    if (strcmp(what, "BEGIN") == 0) {
        command->kind = (uint32_t)self->begin;
        status = read_begin(&text, sum, command);
    } else if (strcmp(what, self->item) == 0) {
        status = read_item(self, robot, &text, sum, command);
    } else if ((strcmp(what, "END") == 0) || (strcmp(what, "RUN") == 0)) {
        command->kind = (uint32_t)((strcmp(what, "END") == 0) ? self->end : self->run);
        status = read_name(&text, *sum, command);
    } else {
        return status;
    }
    return ((status == STATUS_OK) && (workphase_text_next(&text) != NULL)) ? STATUS_OUT_OF_RANGE
                                                                           : status;
}

status_t workphase_lists_read(const workphase_list_t *self, const robot_t *robot,
                              const igtl_message_t *message, uint32_t *sum, command_t *command)
{
    char text[LIMIT_TRAJECTORY_TEXT_BYTES + 1U];
    const size_t begin = strlen(self->word);
    const size_t length = (size_t)message->text_bytes - begin;

    if (length > LIMIT_TRAJECTORY_TEXT_BYTES) {
        return STATUS_OUT_OF_RANGE;
    }
    (void)memcpy(text, &message->text[begin], length);
    text[length] = '\0';
    return read_words(self, robot, text, sum, command);
}
