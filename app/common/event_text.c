/* SPDX-License-Identifier: Apache-2.0 */
#include "common/event_text.h"

#include "common/axis_terms.h"
#include "interface/app/event_words.h"
#include "interface/app/names.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static const char *axis_name(const robot_t *robot, uint32_t axis)
{
    return (axis < robot->axis_count) ? robot->axes[axis].name : "?";
}

/* The number of a card's slot and the axis it drives. */
static void card_name(const robot_t *robot, uint32_t slot, char *text, size_t size)
{
    const char *name = "no axis";
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        name = (robot->axes[i].slot == slot) ? robot->axes[i].name : name;
    }
    (void)snprintf(text, size, "%u (%s)", (unsigned)slot, name);
}

/* A part of the robot's table. */
static const char *part_name(const robot_t *robot, uint32_t part)
{
    return (part < robot->axis_count) ? axis_name(robot, part) : "geometry";
}

/* A number that no enumeration names. */
static void word_text(const robot_t *robot, event_word_t word, uint32_t number, char *text,
                      size_t size)
{
    switch (word) {
    case EVENT_WORD_AXIS:
        (void)snprintf(text, size, "%s", axis_name(robot, number));
        break;
    case EVENT_WORD_CARD:
        card_name(robot, number, text, size);
        break;
    case EVENT_WORD_PART:
        (void)snprintf(text, size, "%s", part_name(robot, number));
        break;
    case EVENT_WORD_LENGTH:
        (void)snprintf(text, size, "%s",
                       (number < robot->probe_length_count) ? robot->probe_names[number] : "?");
        break;
    case EVENT_WORD_NUMBER:
        (void)snprintf(text, size, "%u", (unsigned)number);
        break;
    case EVENT_WORD_NONE:
    default:
        text[0] = '\0';
        break;
    }
}

void event_text_subject(const robot_t *robot, const event_t *event, char *text, size_t size)
{
    const char *name = event_subject_name(event->id, event->subject);

    if (name == NULL) {
        word_text(robot, event_subject_word(event->id), event->subject, text, size);
    } else {
        char owner[32];
        word_text(robot, event_subject_owner(event->id, event->subject), (uint32_t)event->value,
                  owner, sizeof owner);
        (void)snprintf(text, size, "%s%s%s", name, (owner[0] != '\0') ? " " : "", owner);
    }
}

/* Ticks of the axis that the event is about. */
static void ticks_text(const robot_t *robot, const event_t *event, char *text, size_t size)
{
    const axis_config_t *const axis = &robot->axes[event->subject];
    const double thousandths = round((double)event->value * axis_terms_unit(axis) * 1000.0);
    const double way = (thousandths / 1000.0) + 0.0; /* No zero below 0. */

    (void)snprintf(text, size, "%.3f %s (%d ticks)", way, axis_terms_unit_name(axis),
                   (int)event->value);
}

static void value_text(const robot_t *robot, const event_t *event, char *text, size_t size)
{
    const char *const name = event_value_name(event->id, event->value);
    const char *const unit = event_value_unit(event->id);

    if (name != NULL) {
        (void)snprintf(text, size, "%s", name);
    } else if ((strcmp(unit, " ticks") == 0) && (event->subject < robot->axis_count)) {
        ticks_text(robot, event, text, size);
    } else {
        (void)snprintf(text, size, "%d%s", (int)event->value, unit);
    }
}

static bool begins_with(const char *pattern, const char *place)
{
    return strncmp(pattern, place, strlen(place)) == 0;
}

/* Copies `pattern`, a sentence of core/interface/events.yml, and puts words for {subject}, {value}
 * and {peer}. */
static void fill_in(const robot_t *robot, const event_t *event, const char *pattern, char *text,
                    size_t size)
{
    size_t used = 0U;
    text[0] = '\0';
    while ((*pattern != '\0') && (used + 1U < size)) {
        char word[128] = "";
        const char *end = strchr(pattern, '}');
        if (begins_with(pattern, "{subject}")) {
            event_text_subject(robot, event, word, sizeof word);
        } else if (begins_with(pattern, "{value}")) {
            value_text(robot, event, word, sizeof word);
        } else if (begins_with(pattern, "{meaning}")) {
            (void)snprintf(word, sizeof word, "%s", event_value_text(event->id, event->value));
        } else if (begins_with(pattern, "{peer}")) {
            word_text(robot, event_peer_word(event->cause), event->peer, word, sizeof word);
        } else {
            word[0] = *pattern;
            end = pattern;
        }
        pattern = end + 1;
        (void)snprintf(&text[used], size - used, "%s", word);
        used += strlen(&text[used]);
    }
}

void event_text_cause(const robot_t *robot, const event_t *event, const char *page, char *text,
                      size_t size)
{
    const bool is_console = event->cause == (uint32_t)EVENT_CAUSE_CONSOLE;
    if (event->cause == (uint32_t)EVENT_CAUSE_NONE) {
        text[0] = '\0';
    } else if ((event->cause == (uint32_t)EVENT_CAUSE_IGTL) && (event->peer == 0U)) {
        (void)snprintf(text, size, "By the loss of an OpenIGTLink peer.");
    } else if (is_console && (event->peer == 0U)) {
        (void)snprintf(text, size, "By the console.");
    } else if (is_console && (page != NULL)) {
        (void)snprintf(text, size, "By the console, %s.", page);
    } else {
        fill_in(robot, event, event_cause_text((int32_t)event->cause), text, size);
    }
}

void event_text_sentence(const robot_t *robot, const event_t *event, const char *page, char *text,
                         size_t size)
{
    char cause[EVENT_TEXT_CAUSE_SIZE];

    fill_in(robot, event, event_id_text((int32_t)event->id), text, size);
    event_text_cause(robot, event, page, cause, sizeof cause);
    if (cause[0] != '\0') {
        const size_t used = strlen(text);
        (void)snprintf(&text[used], size - used, " %s", cause);
    }
}
