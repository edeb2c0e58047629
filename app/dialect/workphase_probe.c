/* SPDX-License-Identifier: Apache-2.0 */
#include "dialect/workphase_probe.h"

#include "message/igtl_packet.h"
#include "robot/robot.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define WORD "PROBE"
#define WORD_LENGTH (sizeof WORD - 1U)
#define NM_PER_MM 1000000.0
#define MOST_MM 2000.0

static bool is_named(const igtl_message_t *message)
{
    return strcmp(message->name, WORD) == 0;
}

bool workphase_probe_is(const igtl_message_t *message)
{
    const bool begins =
        (message->text_bytes >= WORD_LENGTH) && (memcmp(message->text, WORD, WORD_LENGTH) == 0) &&
        ((message->text_bytes == WORD_LENGTH) || (message->text[WORD_LENGTH] == ' '));

    return is_named(message) || begins;
}

/* One number of the text; false when it is none that a length may be. */
static bool read_length(char **text, int32_t *length_nm)
{
    const char *const begin = *text;
    const double length_mm = strtod(begin, text);
    const bool is_number = (*text != begin) && ((**text == ' ') || (**text == '\0')) &&
                           (length_mm >= -MOST_MM) && (length_mm <= MOST_MM);

    *length_nm = is_number ? (int32_t)lround(length_mm * NM_PER_MM) : 0;
    return is_number;
}

status_t workphase_probe_read(const igtl_message_t *message, command_t *command)
{
    char text[IGTL_TEXT_MAX + 1U];
    char *at = text;
    const uint32_t length =
        (message->text_bytes < IGTL_TEXT_MAX) ? message->text_bytes : IGTL_TEXT_MAX;

    (void)memcpy(text, message->text, length);
    text[length] = '\0';
    at += is_named(message) ? 0U : WORD_LENGTH;
    command->kind = (uint32_t)COMMAND_PROBE;
    command->argument = 0U;
    for (at += strspn(at, " "); *at != '\0'; at += strspn(at, " ")) {
        if ((command->argument >= ROBOT_PROBE_LENGTHS) ||
            !read_length(&at, &command->ticks[command->argument])) {
            return STATUS_OUT_OF_RANGE;
        }
        command->argument++;
    }
    return STATUS_OK;
}
