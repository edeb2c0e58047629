/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Reads a recording. Opening it verifies every byte before any of it is used.
 */
#ifndef BORESIGHT_RECORDING_READER_H
#define BORESIGHT_RECORDING_READER_H

#include "recording/read/recording_state.h"

#include <stdbool.h>

/**
 * Maps and verifies the recording `path`.
 *
 * @return the verdict of `finding`; with RECORDING_WHOLE and RECORDING_CUT_SHORT the reader is open
 *
 * @satisfies SWR-ARM-004
 * @satisfies SWR-REPLAY-002
 * @satisfies SWR-REPLAY-005
 * @satisfies SWR-REPLAY-007
 */
recording_verdict_t recording_reader_open(recording_reader_t *self, const char *path,
                                          recording_finding_t *finding);

/**
 * Says whether the recording's layout and sizes are those of this build; otherwise its records
 * cannot be read.
 *
 * @satisfies SWR-ARM-006
 * @satisfies SWR-REPLAY-006
 */
bool recording_reader_fits(const recording_reader_t *self, uint64_t layout,
                           uint32_t controller_size);

/**
 * The next record, and the knowledge of it. Outputs of a cycle that were not kept are zero. The
 * rows of a checkpoint live until the next call.
 *
 * @return false at the end, or when a block does not hold what its fields say
 */
bool recording_reader_next(recording_reader_t *self, cycle_record_t *record, cycle_known_t *known);

void recording_reader_close(recording_reader_t *self);

#endif
