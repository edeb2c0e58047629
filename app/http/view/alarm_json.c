/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/alarm_json.h"

#include "common/event_text.h"
#include "common/utc_text.h"
#include "http/view/card_alarms.h"
#include "http/view/shown.h"
#include "http/view/telemetry_units.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "interface/card_trouble.h"
#include "interface/link_cause.h"
#include "interface/permit_reason.h"
#include "limits/requirement_limits.h"
#include "robot/robot_cards.h"
#include "safety/needle.h"

#include <stdio.h>
#include <string.h>

#define US_PER_S 1000000.0
#define BIT(number) ((uint32_t)1U << (uint32_t)(number))

typedef struct {
    const telemetry_view_t *view;
    uint32_t reasons; /* Against any axis. */
    cJSON *alarms;
} list_t;

typedef struct {
    event_t event;            /* Its event of the log. */
    permit_reason_t reason;   /* PERMIT_REASON_COUNT: none. */
    uint32_t axis;            /* ROBOT_AXIS_MAX: none. */
    const char *text;         /* NULL: the event's sentence. */
    const char *subject;      /* NULL: the event's. */
    bool is_over;             /* Its cause; it is latched. */
    const alarm_word_t *word; /* When that was; NULL: not known. */
} alarm_t;

static double age_s(const telemetry_view_t *view, uint32_t cycle)
{
    return ((double)(view->snapshot.cycle - cycle) * (double)LIMIT_CYCLE_US) / US_PER_S;
}

static void add(const list_t *list, const alarm_t *alarm)
{
    const robot_t *const robot = list->view->robot;
    const alarm_word_t *const word = alarm->word;
    const bool is_since = (word != NULL) && word->is_known;
    event_t event = alarm->event;
    char subject[EVENT_TEXT_SIZE];
    char text[EVENT_TEXT_SIZE];
    char since[UTC_TEXT_SIZE] = "";
    double age = 0.0;

    event.cause = (uint32_t)EVENT_CAUSE_NONE;
    event_text_subject(robot, &event, subject, sizeof subject);
    event_text_sentence(robot, &event, NULL, text, sizeof text);
    if (is_since) {
        utc_text_write(word->said.utc_us, since);
        age = age_s(list->view, word->said.event.cycle);
    }
    const bool is_reason = (uint32_t)alarm->reason < (uint32_t)PERMIT_REASON_COUNT;
    const json_alarm_t reported = {
        .event = event_id_name((int32_t)event.id),
        .reason = is_reason ? permit_reason_name((int32_t)alarm->reason) : NULL,
        .axis = (alarm->axis < robot->axis_count) ? robot->axes[alarm->axis].name : NULL,
        .is_over = alarm->is_over,
        .subject = (alarm->subject != NULL) ? alarm->subject : subject,
        .text = (alarm->text != NULL) ? alarm->text : text,
        .since = is_since ? since : NULL,
        .age_s = is_since ? &age : NULL};
    (void)cJSON_AddItemToArray(list->alarms, json_alarm(&reported));
}

/* The reason that stands against every axis, if it does. */
static void add_common(const list_t *list, permit_reason_t reason, event_id_t id, alarm_part_t part)
{
    const alarm_word_t *const word = &list->view->alarms.parts[part];
    const bool is_said = (reason == PERMIT_REASON_MEMORY) && word->is_known;
    const alarm_t alarm = {.event = is_said ? word->said.event : (event_t){.id = (uint32_t)id},
                           .reason = reason,
                           .axis = ROBOT_AXIS_MAX,
                           .text = is_said ? NULL : permit_reason_text((int32_t)reason),
                           .is_over = reason == PERMIT_REASON_ESTOP_LATCHED,
                           .word = word};

    if ((list->reasons & BIT(reason)) != 0U) {
        add(list, &alarm);
    }
}

/* Alarm of the cards of all axes together, since the first of them. */
static void add_of_all(const list_t *list, event_t event, common_alarm_t common,
                       const alarm_word_t words[CARD_SLOT_COUNT])
{
    const bool is_loss = event.id == (uint32_t)EVENT_CARD_LOST;
    const alarm_t alarm = {
        .event = event,
        .reason = is_loss ? PERMIT_REASON_LINK_LOST : (permit_reason_t)PERMIT_REASON_COUNT,
        .axis = ROBOT_AXIS_MAX,
        .text = common_alarm_text((int32_t)common),
        .subject = "all",
        .is_over = common == COMMON_ALARM_ANSWER,
        .word =
            (common != COMMON_ALARM_ANSWER) ? card_alarms_first(list->view->robot, words) : NULL};

    add(list, &alarm);
}

static void add_card(const list_t *list, uint32_t slot)
{
    const telemetry_view_t *const view = list->view;
    const alarm_word_t *const word = &view->alarms.cards[slot];
    const bool is_answering = card_alarms_is_back(view, slot);
    const event_t event = {
        .id = EVENT_CARD_LOST, .subject = slot, .value = (int32_t)card_alarms_cause(view, slot)};
    char subject[EVENT_TEXT_SIZE];
    char text[EVENT_TEXT_SIZE * 2];

    event_text_subject(view->robot, &event, subject, sizeof subject);
    (void)snprintf(text, sizeof text, "Card %s %s", subject,
                   common_alarm_text((int32_t)COMMON_ALARM_ONE_ANSWERS));
    const alarm_t alarm = {.event = event,
                           .reason = PERMIT_REASON_LINK_LOST,
                           .axis = robot_cards_axis(view->robot, slot),
                           .text = is_answering ? text : NULL,
                           .is_over = is_answering,
                           .word = is_answering ? NULL : word};
    add(list, &alarm);
}

static void add_cards(const list_t *list)
{
    const telemetry_view_t *const view = list->view;
    const common_alarm_t common = card_alarms_common_loss(view);
    const bool is_common = common != COMMON_ALARM_COUNT;

    if (is_common) {
        add_of_all(list, (event_t){.id = EVENT_CARD_LOST}, common, view->alarms.cards);
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const bool is_of_all = is_common && (robot_cards_axis(view->robot, slot) < ROBOT_AXIS_MAX);
        if (card_alarms_is_lost(view, slot) && !is_of_all) {
            add_card(list, slot);
        }
    }
}

static void add_faults(const list_t *list)
{
    const telemetry_view_t *const view = list->view;
    for (uint32_t i = 0U; i < view->robot->axis_count; i++) {
        const alarm_word_t *const word = &view->alarms.faults[i];
        char text[EVENT_TEXT_SIZE];
        (void)snprintf(text, sizeof text, "Axis %s: %s", view->robot->axes[i].name,
                       permit_reason_text((int32_t)PERMIT_REASON_AXIS_FAULT));
        const event_t unsaid = {.id = EVENT_AXIS_REFERENCE_LOST, .subject = i};
        const alarm_t alarm = {.event = word->is_known ? word->said.event : unsaid,
                               .reason = PERMIT_REASON_AXIS_FAULT,
                               .axis = i,
                               .text = word->is_known ? NULL : text,
                               .word = word};
        if ((uint32_t)view->snapshot.axes[i].power == (uint32_t)AXIS_POWER_FAULT) {
            add(list, &alarm);
        }
    }
}

static void add_recorder(const list_t *list)
{
    const snapshot_t *const snapshot = &list->view->snapshot;
    const alarm_t alarm = {.event = {.id = EVENT_RECORDING_STOPPED,
                                     .value = (snapshot->is_recorder_failing != 0U) ? 1 : 0},
                           .reason = (permit_reason_t)PERMIT_REASON_COUNT,
                           .axis = ROBOT_AXIS_MAX,
                           .word = &list->view->alarms.parts[ALARM_PART_RECORDER]};

    if ((snapshot->is_recorder_failing != 0U) || (snapshot->unrecorded != 0U)) {
        add(list, &alarm);
    }
}

static void add_hot(const list_t *list)
{
    const telemetry_view_t *const view = list->view;
    for (uint32_t i = 0U; i < view->robot->axis_count; i++) {
        const axis_config_t *const config = &view->robot->axes[i];
        const int32_t heat_dc = view->snapshot.cards[config->slot].motor_temperature_dc;
        const alarm_word_t *const word = &view->alarms.faults[i];
        const bool is_its = word->is_known && (word->said.event.id == (uint32_t)EVENT_AXIS_HOT);
        const alarm_t alarm = {.event = {.id = EVENT_AXIS_HOT, .subject = i, .value = heat_dc},
                               .reason = PERMIT_REASON_AXIS_DISABLED,
                               .axis = i,
                               .word = is_its ? word : NULL};
        if (heat_dc > config->hottest_dc) {
            add(list, &alarm);
        }
    }
}

static void add_trouble(const list_t *list, uint32_t slot, uint32_t trouble)
{
    const alarm_word_t *const word = &list->view->alarms.unwell[slot];
    const bool is_its = word->is_known && (word->said.event.value == (int32_t)trouble);
    const bool is_hot = trouble == (uint32_t)CARD_TROUBLE_DRIVER_HOT;
    const alarm_t alarm = {
        .event = {.id = EVENT_CARD_UNWELL, .subject = slot, .value = (int32_t)trouble},
        .reason = is_hot ? PERMIT_REASON_AXIS_DISABLED : (permit_reason_t)PERMIT_REASON_COUNT,
        .axis = robot_cards_axis(list->view->robot, slot),
        .word = is_its ? word : NULL};
    add(list, &alarm);
}

static void add_troubles(const list_t *list)
{
    const telemetry_view_t *const view = list->view;
    uint32_t of_all = 0U;

    for (uint32_t trouble = 0U; trouble < CARD_TROUBLE_COUNT; trouble++) {
        const common_alarm_t common = card_alarms_common_trouble(view, trouble);
        if (common != COMMON_ALARM_COUNT) {
            const event_t event = {.id = EVENT_CARD_UNWELL, .value = (int32_t)trouble};
            add_of_all(list, event, common, view->alarms.unwell);
            of_all |= BIT(trouble);
        }
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const bool is_of_axis = robot_cards_axis(view->robot, slot) < ROBOT_AXIS_MAX;
        const uint32_t reported = is_of_axis ? of_all : 0U;
        for (uint32_t trouble = 0U; trouble < CARD_TROUBLE_COUNT; trouble++) {
            if (card_alarms_has_trouble(view, slot, trouble) && ((reported & BIT(trouble)) == 0U)) {
                add_trouble(list, slot, trouble);
            }
        }
    }
}

/* A position that was known once; a fault has its own sentence. */
static void add_doubts(const list_t *list)
{
    const telemetry_view_t *const view = list->view;
    for (uint32_t i = 0U; i < view->robot->axis_count; i++) {
        const snapshot_axis_t *const axis = &view->snapshot.axes[i];
        const alarm_word_t *const word = &view->alarms.doubts[i];
        const alarm_place_t *const place = &view->alarms.places[i];
        const bool is_lost = (uint32_t)axis->reference == (uint32_t)AXIS_REFERENCE_LOST;
        const bool is_in_doubt = (uint32_t)axis->reference == (uint32_t)AXIS_REFERENCE_UNVERIFIED;
        const event_t unsaid = {.id = is_lost ? EVENT_AXIS_REFERENCE_LOST : EVENT_AXIS_UNVERIFIED,
                                .subject = i,
                                .value = place->ticks};
        const alarm_t alarm = {.event = word->is_known ? word->said.event : unsaid,
                               .reason = PERMIT_REASON_NOT_HOMED,
                               .axis = i,
                               .word = word};
        if ((is_lost || is_in_doubt) && (word->is_known || place->is_known) &&
            ((uint32_t)axis->power != (uint32_t)AXIS_POWER_FAULT)) {
            add(list, &alarm);
        }
    }
}

cJSON *alarm_json_list(const telemetry_view_t *view)
{
    list_t list = {.view = view, .alarms = cJSON_CreateArray()};

    for (uint32_t i = 0U; i < view->robot->axis_count; i++) {
        list.reasons |= view->snapshot.axes[i].permit_reasons;
    }
    add_common(&list, PERMIT_REASON_MEMORY, EVENT_ROBOT_TABLE_DAMAGED, ALARM_PART_TABLE);
    add_common(&list, PERMIT_REASON_INPUTS_UNREAD, EVENT_INPUTS_UNREAD, ALARM_PART_INPUTS);
    add_common(&list, PERMIT_REASON_ESTOP_PULLED, EVENT_ESTOP_PULLED, ALARM_PART_ESTOP);
    add_cards(&list);
    add_common(&list, PERMIT_REASON_LOOP_STOPPED, EVENT_LOOP_STOPPED, ALARM_PART_LOOP);
    add_common(&list, PERMIT_REASON_PEDAL_FAULT, EVENT_PEDAL_FAULT, ALARM_PART_PEDAL);
    add_faults(&list);
    if (view->alarms.parts[ALARM_PART_ESTOP].is_known) { /* It starts latched. */
        add_common(&list, PERMIT_REASON_ESTOP_LATCHED, EVENT_ESTOP_PULLED, ALARM_PART_ESTOP);
    }
    add_hot(&list);
    add_doubts(&list);
    add_recorder(&list);
    add_troubles(&list);
    return list.alarms;
}

static const char *text_of(const cJSON *object, const char *key)
{
    const char *const text = cJSON_GetStringValue(cJSON_GetObjectItem(object, key));
    return (text != NULL) ? text : "";
}

/* A lost card stands against every axis. */
static bool is_against(const cJSON *alarm, const char *axis, const char *reason)
{
    const bool is_of_all = (text_of(alarm, "axis")[0] == '\0') ||
                           (strcmp(reason, permit_reason_name(PERMIT_REASON_LINK_LOST)) == 0);
    return (strcmp(text_of(alarm, "reason"), reason) == 0) &&
           (is_of_all || (strcmp(text_of(alarm, "axis"), axis) == 0));
}

static const cJSON *find(const cJSON *alarms, const char *axis, const char *reason)
{
    const cJSON *alarm = NULL;
    cJSON_ArrayForEach(alarm, alarms)
    {
        if (is_against(alarm, axis, reason)) {
            return alarm;
        }
    }
    return NULL;
}

void alarm_json_name_reasons(const cJSON *alarms, const char *axis, cJSON *permit)
{
    cJSON *reason = NULL;
    cJSON_ArrayForEach(reason, cJSON_GetObjectItem(permit, "reasons"))
    {
        const cJSON *const alarm = find(alarms, axis, text_of(reason, "name"));
        if (alarm != NULL) {
            (void)cJSON_ReplaceItemInObject(reason, "text",
                                            cJSON_CreateString(text_of(alarm, "text")));
        }
    }
}

cJSON *alarm_json_needle(const telemetry_view_t *view)
{
    const uint32_t axis = view->robot->needle_axis;
    const axis_config_t *const config = &view->robot->axes[axis];
    const alarm_place_t *const place = &view->alarms.places[axis];
    const double position = telemetry_units_position(config, place->ticks);
    const double age = age_s(view, place->cycle);
    axis_t axes[ROBOT_AXIS_MAX];

    shown_axes(&view->snapshot, axes);
    const json_needle_t reported = {.axis = config->name,
                                    .unit = telemetry_units_name(config),
                                    .position = place->is_known ? &position : NULL,
                                    .age_s = place->is_known ? &age : NULL,
                                    .is_known = place->is_now,
                                    .may_be_in = !needle_is_out(view->robot, axes)};
    return json_needle(&reported);
}
