/* SPDX-License-Identifier: Apache-2.0 */
/** @file The records of one block of a recording: what of its reader needs no file. */
#ifndef BORESIGHT_RECORDING_BLOCK_H
#define BORESIGHT_RECORDING_BLOCK_H

#include "recording/read/recording_state.h"

#include <stdbool.h>
#include <stdint.h>

/** The block whose `raw_size` bytes stand at the reader's `raw` is the present one; `cycle` is of
 * its first record. */
void recording_block_begin(recording_reader_t *reader, uint32_t raw_size, uint32_t cycle);

/**
 * The next record of the present block, as recording_reader_next() returns it. It needs the size of
 * a checkpoint from the reader's header.
 *
 * @return false at the end of the block, or when it does not hold what it says
 */
bool recording_block_take(recording_reader_t *reader, cycle_record_t *record, cycle_known_t *known);

#endif
