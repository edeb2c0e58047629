/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * What may be asked of the controller, and what it answers. Fixed layout, no padding: these
 * structures cross process boundaries and are recorded.
 */
#ifndef BORESIGHT_COMMAND_H
#define BORESIGHT_COMMAND_H

#include "rigid.h"
#include "workphase.h"

#include <stdint.h>

typedef enum {
    COMMAND_NONE = 0, /**< No command. */
    COMMAND_WORKPHASE =
        1, /**< argument: workphase_t. Answered again at the end of START_UP and MOVE_TO_TARGET. */
    COMMAND_REGISTRATION = 2,         /**< pose: scanner from z-frame. Only in CALIBRATION. */
    COMMAND_TARGET = 3,               /**< pose: scanner from treatment frame. Only in TARGETING. */
    COMMAND_PROPOSE_REGISTRATION = 4, /**< pose: checked and shown, never used for motion. */
    COMMAND_PROPOSE_ENTRY = 5,        /**< pose.translation: entry point in scanner coordinates. */
    COMMAND_PROPOSE_TARGET =
        6, /**< pose.translation: target point in scanner coordinates. Shown, never armed. */
    COMMAND_JOG = 7 /**< argument: axis, value: position in ticks. Only in MANUAL. Answered again at
                       its end. */
} command_kind_t;

#define COMMAND_KIND_COUNT 8U

/** Who asks. What each may send stands in controller_obey.c. */
typedef enum {
    COMMAND_SOURCE_IGTL = 0, /**< The OpenIGTLink process: everything but jogs. */
    COMMAND_SOURCE_HTTP = 1  /**< The console: STOP and jogs. */
} command_source_t;

#define COMMAND_SOURCE_COUNT 2U

typedef struct {
    uint32_t id;     /**< The sender's; echoed in every answer. */
    uint32_t source; /**< command_source_t. */
    uint32_t peer;   /**< Whose it is, for the record: the number of an OpenIGTLink connection, as
                        boresight-igtl says it, 0 when its peer has gone; 0 for the console's stop,
                        which stands for all pages that asked. */
    uint32_t kind;   /**< command_kind_t. */
    uint32_t argument;
    int32_t value;
    rigid_t pose;
} command_t;

/** What an answer says of its command. */
typedef enum {
    ANSWER_ACCEPTED = 0, /**< Done; or begun, when a second answer follows (is_final is 0). */
    ANSWER_REFUSED = 1,  /**< Nothing has changed. */
    ANSWER_DONE = 2,     /**< A long command has ended as asked. */
    ANSWER_ABORTED = 3   /**< A long command has ended early. */
} answer_kind_t;

typedef struct {
    uint32_t id;
    uint32_t source;
    uint32_t command;  /**< command_kind_t. */
    uint32_t argument; /**< Of the command. */
    uint32_t kind;     /**< answer_kind_t. */
    uint32_t status;   /**< status_t. */
    uint32_t is_final; /**< 1: no further answer follows. */
    uint32_t axis;     /**< axis_index_t of STATUS_AXIS_LIMIT, STATUS_SWITCH_ZONE and, in a
                          jog, STATUS_SEPARATION_LIMIT. */
    uint32_t
        is_maximum; /**< 1: the upper limit, with STATUS_AXIS_LIMIT and STATUS_SEPARATION_LIMIT. */
    uint32_t workphase; /**< The workphase after the command. */
    rigid_t pose; /**< COMMAND_TARGET accepted: the reachable pose, scanner coordinates, rounded to
                     ticks. */
} answer_t;

#endif
