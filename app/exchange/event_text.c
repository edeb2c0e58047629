/* SPDX-License-Identifier: Apache-2.0 */
#include "event_text.h"

#include "names.h"
#include "robot.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static const char *axis_name(uint32_t axis)
{
    return (axis < robot_neuro.axis_count) ? robot_neuro.axes[axis].name : "?";
}

/* The number of a card's slot and the axis it drives. */
static void card_name(uint32_t slot, char *text, size_t size)
{
    const char *name = "no axis";
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        name = (robot_neuro.axes[i].slot == slot) ? robot_neuro.axes[i].name : name;
    }
    (void)snprintf(text, size, "%u (%s)", (unsigned)slot, name);
}

/* A chart of which there are several, with whose it is. */
static void chart_text(const event_t *event, char *text, size_t size)
{
    const uint32_t number = (uint32_t)event->value;
    char owner[32] = "";
    if (event->subject == (uint32_t)EVENT_CHART_CARD) {
        card_name(number, owner, sizeof owner);
    } else if (event->subject == (uint32_t)EVENT_CHART_AXIS) {
        (void)snprintf(owner, sizeof owner, "%s", axis_name(number));
    } else {
        /* There is only one. */
    }
    (void)snprintf(text, size, "%s%s%s", event_chart_name((int32_t)event->subject),
                   (owner[0] != '\0') ? " " : "", owner);
}

/* A section of the state; of an axis or its card, with the axis. */
static void memory_text(const event_t *event, char *text, size_t size)
{
    const bool is_of_axis = (event->subject == (uint32_t)EVENT_MEMORY_AXIS) ||
                            (event->subject == (uint32_t)EVENT_MEMORY_CARD);
    (void)snprintf(text, size, "%s%s%s", event_memory_name((int32_t)event->subject),
                   is_of_axis ? " " : "", is_of_axis ? axis_name((uint32_t)event->value) : "");
}

/* A part of the robot's table. */
static const char *part_name(uint32_t part)
{
    return (part < robot_neuro.axis_count) ? axis_name(part) : "geometry";
}

void event_text_subject(const event_t *event, char *text, size_t size)
{
    switch (event->id) {
    case EVENT_WORKPHASE:
    case EVENT_ORDER_ARMED:
        (void)snprintf(text, size, "%s", workphase_name((int32_t)event->subject));
        break;
    case EVENT_COMMAND_REFUSED:
    case EVENT_PROPOSAL:
        (void)snprintf(text, size, "%s", command_kind_name((int32_t)event->subject));
        break;
    case EVENT_CARD_LIVE:
    case EVENT_CARD_LOST:
    case EVENT_FRAME_REFUSED:
        card_name(event->subject, text, size);
        break;
    case EVENT_AXIS_HOMED:
    case EVENT_AXIS_STALLED:
    case EVENT_AXIS_ENCODER_FAULT:
    case EVENT_AXIS_FOLLOWING_ERROR:
    case EVENT_AXIS_HOME_TIMEOUT:
    case EVENT_AXIS_SWITCH_FAULT:
    case EVENT_AXIS_WRONG_WAY:
    case EVENT_AXIS_MOVED_OFF:
    case EVENT_AXIS_NO_COUNTS:
    case EVENT_AXIS_WRONG_SPEED:
    case EVENT_AXIS_TAKEN:
    case EVENT_AXIS_UNVERIFIED:
    case EVENT_AXIS_CONFIRMED:
    case EVENT_AXIS_REFERENCE_LOST:
    case EVENT_ORDER_OVERDUE:
    case EVENT_AXIS_DRIFTED:
    case EVENT_SCAN_DRIFT:
    case EVENT_AXIS_RESTORED:
    case EVENT_AXIS_CONTRADICTED:
    case EVENT_HOMING_BARRED:
    case EVENT_AXIS_SWITCH_ELSEWHERE:
        (void)snprintf(text, size, "%s", axis_name(event->subject));
        break;
    case EVENT_CHART_REPAIRED:
        chart_text(event, text, size);
        break;
    case EVENT_MEMORY_DAMAGED:
        memory_text(event, text, size);
        break;
    case EVENT_ROBOT_TABLE_DAMAGED:
        (void)snprintf(text, size, "%s", part_name(event->subject));
        break;
    case EVENT_OVERRUN:
        (void)snprintf(text, size, "%u", (unsigned)event->subject);
        break;
    default:
        (void)snprintf(text, size, "%s", "");
        break;
    }
}

static void value_text(const event_t *event, const char *how, char *text, size_t size)
{
    if (event->id == (uint32_t)EVENT_COMMAND_REFUSED) {
        (void)snprintf(text, size, "%s", status_name(event->value));
    } else if (event->id == (uint32_t)EVENT_STARTED) {
        (void)snprintf(text, size, "%s", kept_verdict_name(event->value));
    } else if (event->id == (uint32_t)EVENT_CARD_LOST) {
        (void)snprintf(text, size, "%s", link_cause_name(event->value));
    } else if (strncmp(how, "(value, ticks)", 14U) == 0) {
        (void)snprintf(text, size, "%d ticks", (int)event->value);
    } else {
        (void)snprintf(text, size, "%d", (int)event->value);
    }
}

static void peer_text(const event_t *event, char *text, size_t size)
{
    if (event->cause == (uint32_t)EVENT_CAUSE_CARD) {
        card_name(event->peer, text, size);
    } else if (event->cause == (uint32_t)EVENT_CAUSE_AXIS) {
        (void)snprintf(text, size, "%s", axis_name(event->peer));
    } else {
        (void)snprintf(text, size, "%u", (unsigned)event->peer);
    }
}

/* Copies `pattern`, a sentence of event.h, and puts words where it says (subject), (value...) or
 * (peer). */
static void fill_in(const event_t *event, const char *pattern, char *text, size_t size)
{
    size_t used = 0U;
    text[0] = '\0';
    while ((*pattern != '\0') && (used + 1U < size)) {
        const char *end = strchr(pattern, ')');
        char word[48] = "";
        if ((strncmp(pattern, "(subject", 8U) == 0) && (end != NULL)) {
            event_text_subject(event, word, sizeof(word));
            pattern = end + 1;
        } else if ((strncmp(pattern, "(value", 6U) == 0) && (end != NULL)) {
            value_text(event, pattern, word, sizeof(word));
            pattern = end + 1;
        } else if ((strncmp(pattern, "(peer", 5U) == 0) && (end != NULL)) {
            peer_text(event, word, sizeof(word));
            pattern = end + 1;
        } else {
            word[0] = *pattern;
            pattern++;
        }
        (void)snprintf(&text[used], size - used, "%s", word);
        used += strlen(&text[used]);
    }
}

void event_text_cause(const event_t *event, char *text, size_t size)
{
    if (event->cause == (uint32_t)EVENT_CAUSE_NONE) {
        text[0] = '\0';
    } else if ((event->cause == (uint32_t)EVENT_CAUSE_IGTL) && (event->peer == 0U)) {
        (void)snprintf(text, size, "By the loss of an OpenIGTLink peer.");
    } else {
        fill_in(event, event_cause_text((int32_t)event->cause), text, size);
    }
}

void event_text_sentence(const event_t *event, char *text, size_t size)
{
    char cause[EVENT_TEXT_CAUSE_SIZE];

    if (event->id == (uint32_t)EVENT_SCANNER) {
        (void)snprintf(text, size, "The scanner %s acquiring.",
                       (event->value != 0) ? "started" : "ended");
    } else {
        fill_in(event, event_id_text((int32_t)event->id), text, size);
    }
    event_text_cause(event, cause, sizeof(cause));
    if (cause[0] != '\0') {
        const size_t used = strlen(text);
        (void)snprintf(&text[used], size - used, " %s", cause);
    }
}
