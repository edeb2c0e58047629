/* SPDX-License-Identifier: Apache-2.0 */
#include "dialect/workphase_trajectory.h"

#include "limits/requirement_limits.h"
#include "mode/trajectory_row.h"

#include <stdlib.h>
#include <string.h>

static const char word[] = WORKPHASE_TRAJECTORY;

bool workphase_trajectory_is(const igtl_message_t *message)
{
    const size_t length = sizeof word - 1U;
    return (message->text_bytes >= length) && (memcmp(message->text, word, length) == 0) &&
           ((message->text_bytes == length) || (message->text[length] == ' '));
}

/* The next word of `*rest`, a whole number. */
static bool read_number(char **rest, int32_t *number)
{
    char *end = NULL;
    const char *text = strtok_r(NULL, " ", rest);
    if ((text == NULL) || (strspn(text, "+-0123456789") != strlen(text))) {
        return false;
    }
    const long value = strtol(text, &end, 10);
    *number = (int32_t)value;
    return (end != text) && (*end == '\0') && (value >= INT32_MIN) && (value <= INT32_MAX);
}

static bool read_natural(char **rest, uint32_t *number)
{
    int32_t value = 0;
    const bool is_one = read_number(rest, &value) && (value >= 0);
    *number = (uint32_t)value;
    return is_one;
}

static bool read_row(const robot_t *robot, char **rest, command_t *command)
{
    bool is_one = read_natural(rest, &command->argument) && read_number(rest, &command->value) &&
                  (command->value >= 0);
    for (uint32_t i = 0U; (i < robot->axis_count) && is_one; i++) {
        is_one = read_number(rest, &command->ticks[i]);
    }
    for (uint32_t i = 0U; (i < robot->axis_count) && is_one; i++) {
        is_one = read_number(rest, &command->speeds[i]);
    }
    return is_one;
}

static status_t read_words(const robot_t *robot, char *text, uint32_t sum, command_t *command)
{
    char *rest = NULL;
    const char *what = strtok_r(text, " ", &rest);
    bool is_one = true;
    if (what == NULL) {
        return STATUS_UNKNOWN_COMMAND;
    }
    if (strcmp(what, "BEGIN") == 0) {
        command->kind = (uint32_t)COMMAND_LIST_BEGIN;
        is_one = read_natural(&rest, &command->argument);
    } else if (strcmp(what, "ROW") == 0) {
        command->kind = (uint32_t)COMMAND_LIST_ROW;
        is_one = read_row(robot, &rest, command);
    } else if ((strcmp(what, "END") == 0) || (strcmp(what, "RUN") == 0)) {
        command->kind = (strcmp(what, "END") == 0) ? (uint32_t)COMMAND_LIST_END
                                                   : (uint32_t)COMMAND_RUN_TRAJECTORY;
        command->argument = sum;
    } else {
        return STATUS_UNKNOWN_COMMAND;
    }
    return (is_one && (strtok_r(NULL, " ", &rest) == NULL)) ? STATUS_OK : STATUS_OUT_OF_RANGE;
}

status_t workphase_trajectory_read(const robot_t *robot, const igtl_message_t *message,
                                   uint32_t sum, command_t *command)
{
    char text[LIMIT_TRAJECTORY_TEXT_BYTES + 1U];
    const size_t length = (size_t)message->text_bytes - (sizeof word - 1U);

    if (length > LIMIT_TRAJECTORY_TEXT_BYTES) {
        return STATUS_OUT_OF_RANGE;
    }
    (void)memcpy(text, &message->text[sizeof word - 1U], length);
    text[length] = '\0';
    return read_words(robot, text, sum, command);
}

uint32_t workphase_trajectory_sum(uint32_t sum, const command_t *command)
{
    trajectory_row_t row = {.time_ms = (uint32_t)command->value};
    if (command->kind == (uint32_t)COMMAND_LIST_BEGIN) {
        return 0U;
    }
    if (command->kind != (uint32_t)COMMAND_LIST_ROW) {
        return sum;
    }
    (void)memcpy(row.ticks, command->ticks, sizeof row.ticks);
    (void)memcpy(row.speeds_ticks_per_s, command->speeds, sizeof row.speeds_ticks_per_s);
    return trajectory_list_crc(sum, &row);
}
