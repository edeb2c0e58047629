/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Acts of the server on the robot of a page, in the words of a scene: commands that control
 * took and orders that the box carried out. A line each, such as
 * `100:WORKPHASE,id=5,workphase=START_UP` or `200:pedal,press`, the number being the cycle before
 * which it was done.
 */
#ifndef BORESIGHT_JOURNAL_H
#define BORESIGHT_JOURNAL_H

#include "interface/command.h"
#include "site/export.h"

#include <stdint.h>

#define JOURNAL_SIZE (1024U * 1024U)

/** Begins without lines. */
void journal_begin(void);

void journal_note_order(uint32_t cycle, const char *order);

/**
 * Not a note: those are the server's words in the log, of which nothing else comes.
 *
 * @satisfies SWR-SITE-029
 */
void journal_note_command(uint32_t cycle, const command_t *command);

/** The lines since the last time, until the next is noted; NULL: there was no room for all since
 * journal_begin(). */
EXPORT(journal) const char *journal_take(void);

#endif
