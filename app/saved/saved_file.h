/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Saved positions as they come from a client: a file of ours, or a list of motors as older control
 * programs of these robots saved it. Read strictly; what came of it is judged by its seal and age.
 */
#ifndef BORESIGHT_SAVED_FILE_H
#define BORESIGHT_SAVED_FILE_H

#include "interface/app/requests.h"
#include "robot/robot.h"
#include "saved/saved_seal.h"

#define SAVED_FORMAT "boresight-positions/1"
#define SAVED_UTC_SIZE 21U                          /**< "2026-11-22T18:00:00Z" and its end. */
#define SAVED_SUM_SIZE 9U                           /**< CRC-32C as hexadecimal digits. */
#define SAVED_HMAC_SIZE (2U * SAVED_SEAL_SIZE + 1U) /**< The seal as hexadecimal digits. */

/** Whether they can be used, and why not. */
typedef enum {
    SAVED_GOOD = 0,
    SAVED_OTHER_FORMAT = 1,
    SAVED_OTHER_ROBOT = 2,
    SAVED_OTHER_TABLE = 3, /**< The robot had other data. */
    SAVED_BAD_VALUE = 4,   /**< A time, checksum or seal is none. */
    SAVED_BAD_AXES = 5,    /**< An axis is missing, twice there or not the robot's. */
    SAVED_BAD_SLOTS = 6,   /**< The same of a slot. */
    SAVED_ALTERED = 7,     /**< The seal is not of these positions, or another box's. */
    SAVED_TOO_OLD = 8,
    SAVED_FROM_FUTURE = 9
} saved_verdict_t;

/** Where they come from. */
typedef enum {
    SAVED_SEALED = 0,
    SAVED_UNSEALED = 1,
    SAVED_OLD_LIST = 2 /**< Without robot, time and readings. */
} saved_origin_t;

typedef struct {
    saved_origin_t origin;
    position_record_t record;
    uint8_t seal[SAVED_SEAL_SIZE]; /**< Seal of SAVED_SEALED. */
    uint32_t miscounted;           /**< Bit n: axis n has not moved, says the operator. */
} saved_t;

/** Writes whole seconds of `utc_us`. */
void saved_write_utc(uint64_t utc_us, char text[SAVED_UTC_SIZE]);

void saved_write_sum(uint32_t crc, char text[SAVED_SUM_SIZE]);

void saved_write_hmac(const uint8_t *seal, char text[SAVED_HMAC_SIZE]);

/**
 * Reads a file, for `robot`. Any verdict up to SAVED_BAD_AXES.
 *
 * @satisfies SWR-STORE-026
 */
saved_verdict_t saved_read_file(saved_t *self, const request_saved_positions_t *file,
                                const robot_t *robot);

/**
 * Reads a list of motors, for `robot`. SAVED_GOOD or SAVED_BAD_SLOTS.
 *
 * @satisfies SWR-STORE-028
 */
saved_verdict_t saved_read_motors(saved_t *self, const request_old_motor_t *motors, uint32_t count,
                                  const robot_t *robot);

/**
 * Judges what was read at `utc_us`: SAVED_GOOD or any verdict from SAVED_ALTERED on. An old list
 * has neither seal nor time.
 *
 * @satisfies SWR-STORE-026
 */
saved_verdict_t saved_judge(const saved_t *self, const saved_key_t *key, uint64_t utc_us);

#endif
