/* SPDX-License-Identifier: Apache-2.0 */
#include "dialect/workphase_velocity.h"

#include "message/igtl_packet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NM_PER_MM 1.0e6
#define BAM_PER_DEGREE (4294967296.0 / 360.0)
#define ONE_Q16 65536.0
#define MS_PER_S 1000.0

static const char word[] = WORKPHASE_VELOCITY;

bool workphase_velocity_is(const igtl_message_t *message)
{
    const size_t length = sizeof word - 1U;
    return (message->text_bytes >= length) && (memcmp(message->text, word, length) == 0) &&
           ((message->text_bytes == length) || (message->text[length] == ' '));
}

/* Nearest whole number of `unit`s. Digits, sign and point alone: no text makes what is not finite.
 */
static bool read_number(const char *text, double unit, int32_t *number)
{
    char *end = NULL;
    const double exact = round(strtod(text, &end) / unit);
    const bool is_one = (strspn(text, "+-.0123456789") == strlen(text)) && (end != text) &&
                        (*end == '\0') && (exact >= (double)INT32_MIN) &&
                        (exact <= (double)INT32_MAX);
    *number = is_one ? (int32_t)exact : 0;
    return is_one;
}

static double unit_per_tick(const axis_config_t *axis)
{
    const double unit = (axis->unit == (uint8_t)AXIS_UNIT_MM) ? NM_PER_MM : BAM_PER_DEGREE;
    return ((double)axis->unit_per_tick_q16 / ONE_Q16) / unit;
}

static status_t read_speed(const robot_t *robot, const char *name, const char *speed,
                           command_t *command)
{
    uint32_t axis = 0U;
    while ((axis < robot->axis_count) && (strcmp(robot->axes[axis].name, name) != 0)) {
        axis++;
    }
    if (axis == robot->axis_count) {
        return STATUS_UNKNOWN_COMMAND;
    }
    if (((command->argument & (1UL << axis)) != 0U) ||
        !read_number(speed, unit_per_tick(&robot->axes[axis]), &command->ticks[axis])) {
        return STATUS_OUT_OF_RANGE;
    }
    command->argument |= (uint32_t)1U << axis;
    return STATUS_OK;
}

/* Pairs of an axis and its speed, then the time. */
static status_t read_words(const robot_t *robot, char *text, command_t *command)
{
    char *rest = NULL;
    const char *first = strtok_r(text, " ", &rest);
    const char *second = strtok_r(NULL, " ", &rest);
    status_t status = STATUS_OK;

    while ((second != NULL) && (status == STATUS_OK)) {
        status = read_speed(robot, first, second, command);
        first = strtok_r(NULL, " ", &rest);
        second = strtok_r(NULL, " ", &rest);
    }
    if (status != STATUS_OK) {
        return status;
    }
    if (first == NULL) {
        return STATUS_UNKNOWN_COMMAND;
    }
    /* Below 0 it would be a way. */
    return (read_number(first, 1.0 / MS_PER_S, &command->value) && (command->value > 0))
               ? STATUS_OK
               : STATUS_OUT_OF_RANGE;
}

status_t workphase_velocity_read(const robot_t *robot, const igtl_message_t *message,
                                 command_t *command)
{
    char text[IGTL_TEXT_MAX + 1U];
    const size_t length = (size_t)message->text_bytes - (sizeof word - 1U);

    if (length > IGTL_TEXT_MAX) {
        return STATUS_OUT_OF_RANGE;
    }
    (void)memcpy(text, &message->text[sizeof word - 1U], length);
    text[length] = '\0';
    return read_words(robot, text, command);
}
