/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The last act of control, for each cause of its end: every card is commanded to switch its drive
 * off, and their answers are put into words. Needs nothing of the controller's state but two
 * numbers, so that it may follow a broken contract inside a cycle or a memory fault.
 */
#ifndef BORESIGHT_DRIVES_OFF_H
#define BORESIGHT_DRIVES_OFF_H

#include "card/card_dialect.h"
#include "robot/robot.h"

#include <stdint.h>

#define DRIVES_OFF_TEXT_SIZE 160U

/** Its result. */
typedef struct {
    uint32_t sent;      /**< Bit n: the card in slot n was sent "off". */
    uint32_t confirmed; /**< Bit n: it has reported since that its drive is off. */
    uint32_t dialect;   /**< card_dialect_t: none but our own lets a card report that. */
} drives_off_t;

/**
 * Sends every card of `robot` "off", again, at most LIMIT_OFF_EXCHANGES times in all, until each
 * has confirmed it. `dialect` is the card_dialect_t of all cards, `sequence` that of the next
 * frame, `time_us` the controller's time. May be called in a signal handler.
 *
 * @satisfies SWR-CTRL-004
 * @satisfies SWR-CTRL-022
 */
drives_off_t drives_off(const robot_t *robot, uint32_t dialect, uint32_t sequence,
                        uint32_t time_us);

/**
 * Puts into words what was done; ends with a newline. May be called in a signal handler.
 *
 * @satisfies SWR-CTRL-005
 * @satisfies SWR-NI-007
 */
void drives_off_report(const drives_off_t *done, char text[DRIVES_OFF_TEXT_SIZE]);

#endif
