/* SPDX-License-Identifier: Apache-2.0 */
/** @file How each card of a view is, and what has come to all cards of the robot's axes at once. */
#ifndef BORESIGHT_CARD_ALARMS_H
#define BORESIGHT_CARD_ALARMS_H

#include "http/view/telemetry.h"
#include "interface/card_trouble.h"
#include "interface/common_alarm.h"
#include "interface/link_cause.h"

/** Lost, or of an axis and never heard. */
bool card_alarms_is_lost(const telemetry_view_t *view, uint32_t slot);

/** Cause of its last loss, from the events; LINK_CAUSE_NONE: not known. */
link_cause_t card_alarms_cause(const telemetry_view_t *view, uint32_t slot);

/**
 * It is lost and sends frames without a fault by now, and its cause is one that goes by itself.
 *
 * @satisfies SWR-HTTP-150
 */
bool card_alarms_is_back(const telemetry_view_t *view, uint32_t slot);

/**
 * It has this card_trouble_t; of a silent card what it said last is no news.
 *
 * @satisfies SWR-HTTP-152
 */
bool card_alarms_has_trouble(const telemetry_view_t *view, uint32_t slot, uint32_t trouble);

/**
 * The loss of all cards of axes at once; COMMON_ALARM_COUNT: none exists.
 *
 * @satisfies SWR-HTTP-151
 */
common_alarm_t card_alarms_common_loss(const telemetry_view_t *view);

/** The same of a trouble that has a cause in common, of those that are heard. */
common_alarm_t card_alarms_common_trouble(const telemetry_view_t *view, uint32_t trouble);

/** The first of the words about the cards of axes. */
const alarm_word_t *card_alarms_first(const robot_t *robot,
                                      const alarm_word_t words[CARD_SLOT_COUNT]);

#endif
