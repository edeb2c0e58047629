/* SPDX-License-Identifier: Apache-2.0 */
/** @file An event as a sentence for the log, with the names of a robot. */
#ifndef BORESIGHT_EVENT_TEXT_H
#define BORESIGHT_EVENT_TEXT_H

#include "interface/event.h"
#include "robot/robot.h"

#include <stddef.h>

#define EVENT_TEXT_SIZE 816U      /**< Enough for every event, and every note. */
#define EVENT_TEXT_CAUSE_SIZE 80U /**< Enough for every cause. */

/** Subject of the event: "head", "3 (insertion)", "PLANNING"; "" for nothing in particular. */
void event_text_subject(const robot_t *robot, const event_t *event, char *text, size_t size);

/** Cause of the event: "By OpenIGTLink peer 3."; "" when the event states it itself. `page`: title
 * of the page of the console that it was; NULL: by its number. */
void event_text_cause(const robot_t *robot, const event_t *event, const char *page, char *text,
                      size_t size);

/**
 * The event's sentence with its subject and value filled in, and what made it happen; `page` as
 * above.
 *
 * @satisfies SWR-EVENT-007
 * @satisfies SWR-EVENT-180
 */
void event_text_sentence(const robot_t *robot, const event_t *event, const char *page, char *text,
                         size_t size);

#endif
