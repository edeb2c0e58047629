/* SPDX-License-Identifier: Apache-2.0 */
/** @file Recorded motion as comma-separated values with a head: the time in s since 1970, then all
 * series of state, axes and cards. */
#ifndef BORESIGHT_MOTION_CSV_H
#define BORESIGHT_MOTION_CSV_H

#include "replay/data/bytes.h"
#include "replay/data/pace.h"
#include "replay/data/source.h"

#include <stdio.h>

typedef struct {
    FILE *file;
    source_t sources[SOURCES];
    uint32_t count;
    pace_t pace;
    bytes_t row;
} motion_csv_t;

/** Writes the head. */
void motion_csv_begin(motion_csv_t *self, FILE *file, const robot_t *robot);

/**
 * Takes a cycle and writes its row if it is its turn; `shown`: its outputs, NULL: unknown.
 *
 * @satisfies SWR-REPLAY-011
 */
void motion_csv_take(motion_csv_t *self, const recording_header_t *header,
                     const cycle_record_t *record, const snapshot_t *shown);

/** Ends what it needed. */
void motion_csv_end(motion_csv_t *self);

#endif
