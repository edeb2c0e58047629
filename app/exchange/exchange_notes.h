/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Notes of the HTTP server in words, for the log of events: a ring of notes, whose numbers stand in
 * events of control. http writes, everyone reads.
 */
#ifndef BORESIGHT_EXCHANGE_NOTES_H
#define BORESIGHT_EXCHANGE_NOTES_H

#include "exchange/exchange.h"
#include "interface/note_kind.h"
#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/**
 * For http, one thread at a time: keeps a note, in the place of the oldest, and numbers it. A text
 * that is too long is cut.
 *
 * @return its number, which grows by one from 1 on, over restarts of http too
 */
uint32_t exchange_write_note(exchange_t *self, note_kind_t kind, const char *who, const char *text);

/** For http: number of the newest note; 0: none exists. Looked for once, as no other process
 * writes notes. */
uint32_t exchange_newest_note(exchange_t *self);

/**
 * Copies the note `number`; its texts have their ends and no control characters.
 *
 * @return false when it is not kept, not yet or not any more
 *
 * @satisfies SWR-EXCH-019
 */
bool exchange_read_note(const exchange_t *self, uint32_t number, exchange_note_t *note);

/**
 * The sentence of the note that `event` refers to.
 *
 * @return false when it refers to none, or to one that is not kept any more
 *
 * @satisfies SWR-EVENT-010
 */
bool exchange_send_note(const exchange_t *self, const event_t *event, char *text, size_t size);

#endif
