/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A list that came as one NDARRAY, on its way to the controller: the commands of the STRINGs of
 * workphase_lists.h, made here. The array is read whole before the first of them; one array at a
 * time.
 */
#ifndef BORESIGHT_WORKPHASE_ARRAY_H
#define BORESIGHT_WORKPHASE_ARRAY_H

#include "igtl/dialect/igtl_requests.h"
#include "igtl/lists/workphase_list_kind.h"
#include "interface/status.h"
#include "limits/requirement_limits.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_packet.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** All zero but for the items: none is on its way. */
typedef struct {
    bool is_busy;
    bool has_failed; /**< Nothing more of it is passed on; some of it may wait for an answer. */
    uint32_t peer;   /**< The peer that sent it. */
    const workphase_list_t *list; /**< Its kind. */
    const robot_t *robot;
    bool is_owed; /**< `refusal` is sent once nothing of it is on its way. */
    igtl_packet_t refusal;
    uint32_t next; /**< To be passed on: 0 the begin, 1 to `count` an item, then the end. */
    uint32_t count;
    uint32_t crc;                                  /**< Checksum of the list. */
    workphase_item_t items[LIMIT_TRAJECTORY_ROWS]; /**< Beyond `count`: undefined. */
} workphase_array_t;

/**
 * Takes an array of `peer`, an item in each row. A refused array changes nothing unless an earlier
 * array has ended.
 *
 * @return STATUS_OK; STATUS_BUSY while one is on its way; STATUS_NOT_FINITE; STATUS_OUT_OF_RANGE
 * for rows or columns too few or too many, or a number that no item has; as its reader
 *
 * @satisfies SWR-TRAJ-022
 * @satisfies SWR-TRAJ-023
 * @satisfies SWR-TRAJ-024
 */
status_t workphase_array_take(workphase_array_t *self, const workphase_list_t *list,
                              const robot_t *robot, uint32_t peer, const igtl_message_t *message);

/** Something of a list of `peer`, be it of an array or not, waits for its answer: what is answered
 * would be taken for another list's. */
bool workphase_array_is_awaited(const igtl_requests_t *requests, uint32_t peer);

/** Passes on what may be, as of the connection `number`. */
void workphase_array_step(workphase_array_t *self, igtl_requests_t *requests, uint32_t number,
                          uint64_t now_us);

/** `request` is of the array that is on its way. */
bool workphase_array_has(const workphase_array_t *self, const igtl_request_t *request);

/** A refusal, or no answer, of the controller drops the rest. False: it was dropped before. */
bool workphase_array_fail(workphase_array_t *self);

/** `peer` has gone, or its whole list is held. */
void workphase_array_end(workphase_array_t *self, uint32_t peer);

#endif
