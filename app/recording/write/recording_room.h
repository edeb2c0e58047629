/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Time for which the disk of the recordings lasts at the rate at which they grow. The black box
 * owns one.
 */
#ifndef BORESIGHT_RECORDING_ROOM_H
#define BORESIGHT_RECORDING_ROOM_H

#include <stdint.h>

/** At first all zero. */
typedef struct {
    uint64_t looked_us;
    uint64_t size;        /**< Size of the present file then, bytes. */
    uint64_t bytes_per_s; /**< 0: nothing was measured. */
    uint32_t left_min;    /**< Until the disk is full, from 1, also when it is full; 0: no end is
                             foreseen, also before    the first measurement. */
} recording_room_t;

/**
 * Looks at the folder once in LIMIT_RECORDING_LOOK_US. The recordings before the present one have
 * `earlier_bytes`, the present one `size`. The first look at a file, which is shorter than the one
 * before, measures nothing.
 *
 * @satisfies SWR-REC-035
 */
void recording_room_look(recording_room_t *self, const char *directory, uint64_t earlier_bytes,
                         uint64_t size, uint64_t now_us);

#endif
