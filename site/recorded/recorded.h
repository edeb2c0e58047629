/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Functions that a page may call of the module recorded.wasm, which reads one recording as
 * boresight-replay does and writes of it what the page of a recording shows. It imports nothing. A
 * contract that is broken is printed and traps.
 */
#ifndef BORESIGHT_RECORDED_H
#define BORESIGHT_RECORDED_H

#include "site/export.h"

#include <stdbool.h>
#include <stdint.h>

#define RECORDED_NAME_SIZE 256U
#define RECORDED_ALL 1000U

/** Room for the name of the file, RECORDED_NAME_SIZE bytes ended by a zero. */
EXPORT(name) char *recorded_name(void);

/** Room for the bytes of the file; NULL: there is none. Once. */
EXPORT(room) uint8_t *recorded_room(uint32_t size);

/**
 * Verifies every byte that stands there. False: the recording is refused, and why was printed.
 *
 * @satisfies SWR-SITE-036
 */
EXPORT(open) bool recorded_open(void);

/**
 * Replays at most so many records more. Needs a recording that is open and not done (contract 330).
 * Share of it that is done, of RECORDED_ALL, which is returned at the end alone.
 *
 * @satisfies SWR-SITE-035
 */
EXPORT(goOn) uint32_t recorded_go_on(uint32_t records);

/** Data that the page shows, as motion_json.h states; when all is done. */
EXPORT(document) const char *recorded_document(void);
EXPORT(documentSize) uint32_t recorded_document_size(void);

/** Output on the standard error so far, as a text. */
EXPORT(printed) const char *recorded_printed(void);

#endif
