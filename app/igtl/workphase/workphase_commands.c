/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_commands.h"

#include "common/axis_terms.h"
#include "igtl/lists/workphase_text.h"
#include "interface/app/names.h"
#include "igtl/wire/igtl_packet.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define UM_PER_MM 1000.0
#define NM_PER_MM 1.0e6
#define MOST_MM 2000.0
#define MS_PER_S 1000.0
#define MOST_S 1.0e6
#define MOST_PER_M 20.0
#define MOST_DEG 360.0
#define PER_KM 1000.0

status_t workphase_read_pose_name(const robot_t *robot, char *text, command_t *command)
{
    (void)robot;
    for (uint32_t i = 0U; i < POSE_NAME_COUNT; i++) {
        if (strcmp(pose_name_name((int32_t)i), text) == 0) {
            command->as.pose_name.pose = i;
            return STATUS_OK;
        }
    }
    return STATUS_UNKNOWN_COMMAND;
}

static const char *unit_of(const axis_config_t *axis, const char *of_mm, const char *of_deg)
{
    return (axis->unit == (uint8_t)AXIS_UNIT_MM) ? of_mm : of_deg;
}

static status_t read_speed(const robot_t *robot, const char *name, char **text,
                           command_velocity_t *velocity)
{
    const char *speed = workphase_text_next(text);
    const char *unit = workphase_text_next(text);
    const uint32_t axis = axis_terms_find(robot, name);
    const uint32_t mask = (uint32_t)1U << axis;

    if (axis == robot->axis_count) {
        return STATUS_UNKNOWN_COMMAND;
    }
    if (((velocity->axes & mask) != 0U) ||
        !workphase_text_ticks(speed, &robot->axes[axis], &velocity->speeds_ticks_per_s[axis])) {
        return STATUS_OUT_OF_RANGE;
    }
    velocity->axes |= mask;
    return workphase_text_is(unit, unit_of(&robot->axes[axis], "mm/s", "deg/s"))
               ? STATUS_OK
               : STATUS_WRONG_UNIT;
}

/* An axis and where it shall go, or by which way, with its unit. */
static status_t read_way(const robot_t *robot, char *text, uint32_t *axis, int32_t *ticks)
{
    const char *name = workphase_text_next(&text);
    const char *way = workphase_text_next(&text);
    const char *unit = workphase_text_next(&text);

    *axis = (name == NULL) ? robot->axis_count : axis_terms_find(robot, name);
    if ((*axis == robot->axis_count) || (workphase_text_next(&text) != NULL)) {
        return STATUS_UNKNOWN_COMMAND;
    }
    if (!workphase_text_ticks(way, &robot->axes[*axis], ticks)) {
        return STATUS_OUT_OF_RANGE;
    }
    return workphase_text_is(unit, unit_of(&robot->axes[*axis], "mm", "deg")) ? STATUS_OK
                                                                              : STATUS_WRONG_UNIT;
}

status_t workphase_read_jog(const robot_t *robot, char *text, command_t *command)
{
    return read_way(robot, text, &command->as.jog.axis, &command->as.jog.to_ticks);
}

status_t workphase_read_jog_by(const robot_t *robot, char *text, command_t *command)
{
    return read_way(robot, text, &command->as.jog_by.axis, &command->as.jog_by.by_ticks);
}

static status_t read_time(const char *word, char **text, command_velocity_t *velocity)
{
    const char *unit = workphase_text_next(text);
    double time_s;

    if (!workphase_text_number(word, MOST_S, &time_s)) {
        return STATUS_OUT_OF_RANGE;
    }
    const long time_ms = lround(time_s * MS_PER_S);
    if (time_ms <= 0L) {
        return STATUS_OUT_OF_RANGE;
    }
    velocity->time_ms = (uint32_t)time_ms;
    return (workphase_text_is(unit, "s") && (workphase_text_next(text) == NULL))
               ? STATUS_OK
               : STATUS_WRONG_UNIT;
}

/* Axes, each with its speed, then the time, all with their units. */
status_t workphase_read_velocity(const robot_t *robot, char *text, command_t *command)
{
    const char *word = workphase_text_next(&text);
    bool is_axis = (word != NULL) && (axis_terms_find(robot, word) < robot->axis_count);

    while (is_axis) {
        const status_t status = read_speed(robot, word, &text, &command->as.velocity);

        if (status != STATUS_OK) {
            return status;
        }
        word = workphase_text_next(&text);
        is_axis = (word != NULL) && (axis_terms_find(robot, word) < robot->axis_count);
    }
    if ((word == NULL) || (command->as.velocity.axes == 0U)) {
        return STATUS_UNKNOWN_COMMAND;
    }
    return read_time(word, &text, &command->as.velocity);
}

/* An axis, and that it is free. */
status_t workphase_read_sweep(const robot_t *robot, char *text, command_t *command)
{
    const char *name = workphase_text_next(&text);
    const char *word = workphase_text_next(&text);
    const uint32_t axis = (name == NULL) ? robot->axis_count : axis_terms_find(robot, name);
    const bool is_free = (word != NULL) && (strcmp(word, "FREE") == 0);

    if ((axis == robot->axis_count) || ((word != NULL) && !is_free) ||
        (workphase_text_next(&text) != NULL)) {
        return STATUS_UNKNOWN_COMMAND;
    }
    command->as.sweep = (command_sweep_t){.axis = axis, .is_free = is_free ? 1U : 0U};
    return STATUS_OK;
}

/* `taken`: the lengths that were named before, bit n: that of place n. */
static status_t read_length(const robot_t *robot, const char *name, const char *length,
                            uint32_t *taken, command_t *command)
{
    uint32_t place = 0U;
    double length_mm;

    while ((place < robot->probe_length_count) && (strcmp(robot->probe_names[place], name) != 0)) {
        place++;
    }
    if ((place == robot->probe_length_count) || (((*taken >> place) & 1U) != 0U)) {
        return STATUS_PROBE_LENGTH;
    }
    if (!workphase_text_number(length, MOST_MM, &length_mm)) {
        return STATUS_OUT_OF_RANGE;
    }
    *taken |= (uint32_t)1U << place;
    command->as.probe.lengths_nm[place] = (int32_t)lround(length_mm * NM_PER_MM);
    command->as.probe.count++;
    return STATUS_OK;
}

/* Pairs of a length's name and its mm. */
status_t workphase_read_probe(const robot_t *robot, char *text, command_t *command)
{
    uint32_t taken = 0U;

    for (const char *name = workphase_text_next(&text); name != NULL;
         name = workphase_text_next(&text)) {
        const status_t status =
            read_length(robot, name, workphase_text_next(&text), &taken, command);

        if (status != STATUS_OK) {
            return status;
        }
    }
    return (command->as.probe.count == robot->probe_length_count) ? STATUS_OK : STATUS_PROBE_LENGTH;
}

static uint32_t steering_named(const char *word)
{
    uint32_t method = 0U;

    while ((method < STEERING_METHOD_COUNT) &&
           !workphase_text_is(word, steering_method_name((int32_t)method))) {
        method++;
    }
    return method;
}

/* A number and its unit. */
static status_t read_quantity(char **text, const char *unit, double most, double *value)
{
    if (!workphase_text_number(workphase_text_next(text), most, value)) {
        return STATUS_OUT_OF_RANGE;
    }
    return workphase_text_is(workphase_text_next(text), unit) ? STATUS_OK : STATUS_WRONG_UNIT;
}

/* A method, and but for NONE a curvature in /m and a direction in degrees. */
status_t workphase_read_steering(const robot_t *robot, char *text, command_t *command)
{
    command_steering_t *const sent = &command->as.steering;
    double curvature_per_m = 0.0;
    double direction_deg = 0.0;
    status_t status = STATUS_OK;

    (void)robot;
    sent->method = steering_named(workphase_text_next(&text));
    if (sent->method == STEERING_METHOD_COUNT) {
        return STATUS_UNKNOWN_COMMAND;
    }
    if (sent->method != (uint32_t)STEERING_NONE) {
        status = read_quantity(&text, "/m", MOST_PER_M, &curvature_per_m);
        if (status == STATUS_OK) {
            status = read_quantity(&text, "deg", MOST_DEG, &direction_deg);
        }
    }
    if ((status == STATUS_OK) &&
        ((curvature_per_m < 0.0) || (workphase_text_next(&text) != NULL))) {
        status = STATUS_OUT_OF_RANGE;
    }
    if (status == STATUS_OK) {
        sent->curvature_per_km = (uint32_t)lround(curvature_per_m * PER_KM);
        sent->direction_deg = (int32_t)lround(direction_deg);
    }
    return status;
}

/* Depths in mm. */
status_t workphase_read_membranes(const robot_t *robot, char *text, command_t *command)
{
    command_membranes_t *const sent = &command->as.membranes;

    (void)robot;
    for (const char *word = workphase_text_next(&text); word != NULL;
         word = workphase_text_next(&text)) {
        double depth_mm;

        if ((sent->count == LIMIT_MEMBRANES_MOST) ||
            !workphase_text_number(word, MOST_MM, &depth_mm)) {
            return STATUS_OUT_OF_RANGE;
        }
        sent->depths_um[sent->count] = (int32_t)lround(depth_mm * UM_PER_MM);
        sent->count++;
    }
    return STATUS_OK;
}

static bool is_named(const workphase_command_t *word, const igtl_message_t *message)
{
    return strcmp(message->name, word->word) == 0;
}

/* A name is an order only if the text says nothing else. Deployed clients retract by the name,
 * with any text. */
static bool means(const workphase_command_t *word, const igtl_message_t *message)
{
    const bool is_any_text = (word->reader != NULL) || (word->kind == COMMAND_RETRACT);

    return igtl_is_text(message, word->word) ||
           (is_named(word, message) && (is_any_text || (message->text_bytes == 0U)));
}

static bool begins(const workphase_command_t *word, const igtl_message_t *message)
{
    const size_t length = strlen(word->word);

    return (message->text_bytes > length) && (message->text[length] == ' ') &&
           (memcmp(message->text, word->word, length) == 0);
}

const workphase_command_t *workphase_commands_find(const igtl_message_t *message)
{
    for (size_t i = 0U; i < workphase_command_count; i++) {
        const workphase_command_t *word = &workphase_commands[i];

        if (means(word, message) || ((word->reader != NULL) && begins(word, message))) {
            return word;
        }
    }
    return NULL;
}

void workphase_commands_send_form(const robot_t *robot, status_t status,
                                  char text[IGTL_REASON_SIZE])
{
    int used = snprintf(text, IGTL_REASON_SIZE, "%s: Send each length by its name, in mm: PROBE",
                        status_name((int32_t)status));

    for (uint32_t i = 0U; (i < robot->probe_length_count) && (used < (int)IGTL_REASON_SIZE); i++) {
        used += snprintf(&text[used], IGTL_REASON_SIZE - (size_t)used, " %s %.9g",
                         robot->probe_names[i], (double)robot->probe.length_nm[i] / NM_PER_MM);
    }
}

status_t workphase_commands_read(const workphase_command_t *word, const robot_t *robot,
                                 const igtl_message_t *message, command_t *command)
{
    char text[IGTL_TEXT_MAX + 1U];
    const size_t begin = is_named(word, message) ? 0U : strlen(word->word);
    const size_t length = (size_t)message->text_bytes - begin;

    command->kind = (uint32_t)word->kind;
    command->as = word->as;
    if (word->reader == NULL) {
        return STATUS_OK;
    }
    if (length > IGTL_TEXT_MAX) {
        return STATUS_OUT_OF_RANGE;
    }
    (void)memcpy(text, &message->text[begin], length);
    text[length] = '\0';
    return word->reader(robot, &text[strspn(text, " ")], command);
}
