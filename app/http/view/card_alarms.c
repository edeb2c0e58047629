/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/card_alarms.h"

#include "interface/link_cause.h"
#include "procedure/guards.h"
#include "robot/robot_cards.h"

#define BIT(number) ((uint32_t)1U << (uint32_t)(number))

/* An unknown time is later than any other. */
static const alarm_word_t *earlier(const alarm_word_t *one, const alarm_word_t *other)
{
    return (one->is_known &&
            (!other->is_known || (other->said.event.cycle > one->said.event.cycle)))
               ? one
               : other;
}

bool card_alarms_is_lost(const telemetry_view_t *view, uint32_t slot)
{
    const uint32_t link = (uint32_t)view->snapshot.cards[slot].link;
    const bool is_missing = (robot_cards_axis(view->robot, slot) < ROBOT_AXIS_MAX) &&
                            (link == (uint32_t)CARD_LINK_STATE_ABSENT);
    return (link == (uint32_t)CARD_LINK_STATE_LOST) || is_missing;
}

link_cause_t card_alarms_cause(const telemetry_view_t *view, uint32_t slot)
{
    const alarm_word_t *const word = &view->alarms.cards[slot];
    return word->is_known ? (link_cause_t)word->said.event.value : LINK_CAUSE_NONE;
}

bool card_alarms_is_back(const telemetry_view_t *view, uint32_t slot)
{
    static const uint32_t passing = BIT(LINK_CAUSE_AGE) | BIT(LINK_CAUSE_FAULT) |
                                    BIT(LINK_CAUSE_REFUSED) | BIT(LINK_CAUSE_LATE) |
                                    BIT(LINK_CAUSE_BUS_ERROR) | BIT(LINK_CAUSE_LOOP_LATE);
    const snapshot_card_t *const card = &view->snapshot.cards[slot];
    const link_cause_t cause = card_alarms_cause(view, slot);
    const bool is_passing = (cause == LINK_CAUSE_NONE)
                                ? guards_have(view->snapshot.guards, GUARD_HARDWARE_READY)
                                : ((passing & BIT(cause)) != 0U);
    return ((uint32_t)card->link == (uint32_t)CARD_LINK_STATE_LOST) && (card->age_cycles == 0U) &&
           is_passing;
}

/* The loss that may be common to all cards; COMMON_ALARM_COUNT: none. */
static common_alarm_t common_loss(const telemetry_view_t *view, uint32_t slot)
{
    common_alarm_t loss = COMMON_ALARM_COUNT;

    if (!card_alarms_is_lost(view, slot)) {
        return loss;
    }
    if (card_alarms_is_back(view, slot)) {
        return COMMON_ALARM_ANSWER;
    }
    switch (card_alarms_cause(view, slot)) {
    case LINK_CAUSE_NONE:
    case LINK_CAUSE_AGE:
    case LINK_CAUSE_REFUSED:
    case LINK_CAUSE_LATE:
    case LINK_CAUSE_BUS_ERROR:
        loss = COMMON_ALARM_SILENT;
        break;
    case LINK_CAUSE_LOOP_LATE:
        loss = COMMON_ALARM_LOOP_LATE;
        break;
    case LINK_CAUSE_FAULT:
    case LINK_CAUSE_ECHO:
    case LINK_CAUSE_WRONG_CARD:
    case LINK_CAUSE_MEMORY:
    default:
        break;
    }
    return loss;
}

/* Its last report is no news. */
static bool is_silent(const telemetry_view_t *view, uint32_t slot)
{
    return card_alarms_is_lost(view, slot) && (view->snapshot.cards[slot].age_cycles != 0U) &&
           (card_alarms_cause(view, slot) == LINK_CAUSE_AGE);
}

bool card_alarms_has_trouble(const telemetry_view_t *view, uint32_t slot, uint32_t trouble)
{
    return !is_silent(view, slot) && ((view->snapshot.cards[slot].troubles & BIT(trouble)) != 0U);
}

static common_alarm_t common_trouble(uint32_t trouble)
{
    static const common_alarm_t common[CARD_TROUBLE_COUNT] = {
        [CARD_TROUBLE_SUPPLY_LOW] = COMMON_ALARM_SUPPLY_LOW,
        [CARD_TROUBLE_SUPPLY_HIGH] = COMMON_ALARM_SUPPLY_HIGH,
        [CARD_TROUBLE_DRIVER_WARM] = COMMON_ALARM_COUNT,
        [CARD_TROUBLE_DRIVER_HOT] = COMMON_ALARM_COUNT,
        [CARD_TROUBLE_COMMANDS_REFUSED] = COMMON_ALARM_REFUSE,
        [CARD_TROUBLE_WATCHDOG_TRIPPED] = COMMON_ALARM_TRIPPED};
    return common[trouble];
}

static bool is_trouble_of_all(const telemetry_view_t *view, uint32_t trouble)
{
    uint32_t heard = 0U;
    uint32_t having = 0U;

    for (uint32_t i = 0U; i < view->robot->axis_count; i++) {
        const uint32_t slot = view->robot->axes[i].slot;
        heard += is_silent(view, slot) ? 0U : 1U;
        having += card_alarms_has_trouble(view, slot, trouble) ? 1U : 0U;
    }
    return (heard > 1U) && (having == heard);
}

common_alarm_t card_alarms_common_trouble(const telemetry_view_t *view, uint32_t trouble)
{
    return is_trouble_of_all(view, trouble) ? common_trouble(trouble) : COMMON_ALARM_COUNT;
}

common_alarm_t card_alarms_common_loss(const telemetry_view_t *view)
{
    const robot_t *const robot = view->robot;
    const common_alarm_t common = common_loss(view, robot->axes[0].slot);
    bool is_common = robot->axis_count > 1U;

    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        is_common = is_common && (common_loss(view, robot->axes[i].slot) == common);
    }
    return is_common ? common : COMMON_ALARM_COUNT;
}

const alarm_word_t *card_alarms_first(const robot_t *robot,
                                      const alarm_word_t words[CARD_SLOT_COUNT])
{
    const alarm_word_t *word = &words[robot->axes[0].slot];

    for (uint32_t i = 1U; i < robot->axis_count; i++) {
        word = earlier(word, &words[robot->axes[i].slot]);
    }
    return word;
}
