/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Where the axes stand, and when and where that was so: what is kept over a restart and what people
 * save. As bytes, little endian:
 *
 *     magic (8), number (8), UTC in us (8), power-on (4), CRC of the robot's table (4),
 *     per axis grade, position and reading (12 each), CRC-32C of all that (4)
 */
#ifndef BORESIGHT_POSITION_RECORD_H
#define BORESIGHT_POSITION_RECORD_H

#include "controller/kept.h"
#include "interface/snapshot.h"

#include <stdbool.h>
#include <stdint.h>

#define POSITION_RECORD_SIZE (36U + (12U * ROBOT_AXIS_MAX))

typedef struct {
    uint64_t number; /**< Number among the records of a file; one that is saved is 0. */
    uint64_t utc_us;
    uint32_t power_on;
    uint32_t robot_crc;
    kept_axis_t axes[ROBOT_AXIS_MAX];
} position_record_t;

/**
 * Takes what `snapshot` says at `utc_us` as record 0.
 *
 * @return false while an axis moves or waits for its first report: it may be elsewhere by then
 */
bool position_record_take(position_record_t *self, const snapshot_t *snapshot, uint64_t utc_us);

/** Fills POSITION_RECORD_SIZE bytes. */
void position_record_encode(const position_record_t *self, uint8_t *bytes);

/** False when any of POSITION_RECORD_SIZE bytes is not as it was written. */
bool position_record_decode(const uint8_t *bytes, position_record_t *self);

#endif
