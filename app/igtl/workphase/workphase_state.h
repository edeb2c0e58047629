/* SPDX-License-Identifier: Apache-2.0 */
/** @file The state of the workphase protocol: each peer, and all of them; workphase_dialect.h owns
 * it. */
#ifndef BORESIGHT_WORKPHASE_STATE_H
#define BORESIGHT_WORKPHASE_STATE_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_questions.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/lists/workphase_array.h"
#include "igtl/lists/workphase_list_kind.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_outbox.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

#define WORKPHASE_EXTRAS 4U /**< Deferred messages per peer. */
#define WORKPHASE_IDS 10U   /**< Command ids remembered per peer. */

/** A message that waits for its time. */
typedef struct {
    uint64_t due_us;
    igtl_packet_t packet;
} workphase_extra_t;

/** A command that came. */
typedef struct {
    char name[IGTL_NAME_SIZE]; /**< Empty: none. */
    uint64_t text_crc;
    uint32_t text_bytes;
    uint32_t request; /**< Id of what became of it, 0 for nothing. */
} workphase_id_t;

/** The end of an order that waits until a newer command of the same peer is answered. */
typedef struct {
    bool is_waiting;
    bool is_discarded; /**< Nothing is said of it if the newer command was accepted: that ended it.
                        */
    igtl_packet_t packet;
} workphase_end_t;

/** Needle tips as an image shows them: the newest waits for its turn. */
typedef struct {
    bool is_waiting;
    rigid_t pose;
    uint64_t next_us;      /**< Not passed on before. */
    uint64_t next_note_us; /**< Not before this time is one for the log again. */
} workphase_tip_t;

typedef struct {
    igtl_outbox_t *outbox; /**< NULL: not connected. */
    uint32_t number;       /**< Number of its connection. */
    igtl_language_t language;
    const char *entry_prefix;
    workphase_id_t ids[WORKPHASE_IDS]; /**< The last commands, a ring. */
    uint32_t next_id;
    uint32_t pending; /**< Id of its newest workphase or motion without an answer, 0: none. */
    workphase_end_t end;
    workphase_tip_t tip;
    const char *motion; /**< By which word it asked for its last motion. */
    uint32_t draping; /**< Id of its request of MANUAL, after which it goes to the pose DRAPING. */
    uint32_t sums[WORKPHASE_LIST_COUNT]; /**< Checksums of its items, by the kind of list. */
    uint32_t steps_reported; /**< Number of done steps of its program that were reported to it. */
    igtl_tracking_t tracking;
    workphase_extra_t extras[WORKPHASE_EXTRAS];
    uint32_t extra_count;
} workphase_peer_t;

/** The state that the controlling peer knows, by answers and notifications. */
typedef struct {
    uint32_t workphase;
    uint32_t estop;
    uint32_t pose_status;
    uint32_t lost_cards;  /**< Bit n: the card of slot n. */
    uint32_t axis_faults; /**< Bit n: axis n. */
    uint32_t is_loop_stopped;
    uint32_t is_pedal_faulty;
} workphase_facts_t;

/** Between snapshots. */
typedef struct {
    bool has_facts;
    workphase_facts_t facts;
    bool is_waiting; /**< Something is to be reported, since... */
    uint64_t waiting_since_us;
    bool is_control_lost; /**< At this cycle. */
    uint32_t cycle;
} workphase_notifications_t;

typedef struct {
    const robot_t *robot;
    igtl_requests_t requests;
    workphase_notifications_t watch;
    workphase_peer_t peers[IGTL_SLOTS];
    uint32_t controller;       /**< Peer that has authority as control shows it, or IGTL_NOBODY. */
    uint64_t next_position_us; /**< When the next CURRENT_POSITION is due. */
    bool is_new;               /**< The authority of an earlier run is not released yet. */
    workphase_array_t array;   /**< The last, as its items are. */
} workphase_dialect_t;

#endif
