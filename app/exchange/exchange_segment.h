/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The layout of the exchange's segment, and how it is created and found. Private to app/exchange.
 *
 * Three parts on pages of their own: what control writes, what the recorder writes alone, and what
 * everybody else writes. A process that called exchange_protect() cannot write the first, and only
 * the recorder the second, even by a stray pointer. Indices only grow and are reduced when
 * used, so that no value found in the segment leads outside of it.
 *
 * Any process may damage a part that is not control's. No process trusts its own part: a process
 * that lives keeps its indices and its published values, and writes them again; a process that
 * starts trusts only sealed values. In a command lane, which has a writer that may be replaced,
 * control sets its own index right.
 */
#ifndef BORESIGHT_EXCHANGE_SEGMENT_H
#define BORESIGHT_EXCHANGE_SEGMENT_H

#include "exchange/exchange_lock.h"
#include "exchange/exchange_record.h"
#include "exchange/exchange_values.h"
#include "interface/answer.h"
#include "interface/command.h"
#include "interface/loop_figures.h"
#include "interface/snapshot.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define SEGMENT_MAGIC UINT64_C(0x32484358454F5242) /**< "BROEXCH2", little endian. */
#define SEGMENT_PAGE 4096
#define SEGMENT_LINE 64
/** Copies written in turn: a reader has three cycles for one copy. */
#define SEGMENT_SNAPSHOTS 4U
#define SEGMENT_COMMANDS (EXCHANGE_COMMANDS + EXCHANGE_STOPS) /**< A power of 2. */
#define SEGMENT_NAME_SIZE 64U
#define SEGMENT_STOP (UINT64_C(1) << 32)

#define SEGMENT_ON_PAGE __attribute__((aligned(SEGMENT_PAGE)))
#define SEGMENT_ON_LINE __attribute__((aligned(SEGMENT_LINE)))

/** A snapshot under a sequence lock: the sequence is odd while it is being written. */
typedef struct {
    uint32_t sequence SEGMENT_ON_LINE;
    snapshot_t snapshot;
} segment_snapshot_t;

/** An event under a sequence lock. */
typedef struct {
    uint32_t sequence;
    exchange_event_t event;
} segment_event_t;

typedef struct {
    exchange_seal_t seal;
    exchange_note_t note;
} segment_note_t;

/** A command, and the check that it and its number in the lane have. */
typedef struct {
    uint32_t check;
    command_t command;
} segment_command_t;

/** Commands of one source. */
typedef struct {
    uint32_t head SEGMENT_ON_LINE; /**< Commands put in. */
    segment_command_t commands[SEGMENT_COMMANDS];
} segment_commands_t;

/** Answers to one source. */
typedef struct {
    uint32_t head SEGMENT_ON_LINE; /**< Answers put in. */
    answer_t answers[EXCHANGE_ANSWERS];
} segment_answers_t;

/** The clients of one source. */
typedef struct {
    exchange_seal_t seal SEGMENT_ON_LINE;
    exchange_peers_t peers;
} segment_peers_t;

/** The order of http to igtl. */
typedef struct {
    exchange_seal_t seal SEGMENT_ON_LINE;
    exchange_order_t order;
} segment_order_t;

typedef struct {
    uint32_t id;     /**< Number of the order. */
    uint32_t status; /**< status_t. */
} segment_answered_t;

/** The answer of igtl. */
typedef struct {
    exchange_seal_t seal SEGMENT_ON_LINE;
    segment_answered_t answer;
} segment_order_answer_t;

/** Written by the creator alone, all but the last before the magic, and not changed afterwards. */
typedef struct {
    uint64_t magic;
    uint64_t layout;        /**< segment_layout() of the creator's build. */
    uint64_t run;           /**< As exchange_run() says. */
    uint32_t cycles;        /**< Entries of the lane of cycles. */
    uint32_t control_ended; /**< 0 or 1. */
} segment_header_t;

/** Written by every process but control. Numbers of 64 bit but stops are sealed. */
typedef struct {
    struct {
        uint32_t count SEGMENT_ON_LINE;
    } beats[EXCHANGE_PROCESS_COUNT];
    uint64_t stops_requested SEGMENT_ON_LINE; /**< SEGMENT_STOP each, an EMERGENCY 1 more. */
    uint64_t stop_port SEGMENT_ON_LINE;       /**< 0: none was noted. */
    uint64_t replaced[EXCHANGE_PROCESS_COUNT] SEGMENT_ON_LINE; /**< How often, not logged yet. */
    segment_commands_t lanes[COMMAND_SOURCE_COUNT];
    struct {
        uint32_t tail SEGMENT_ON_LINE; /**< Answers taken. */
    } answered[COMMAND_SOURCE_COUNT];
    uint64_t end_requested SEGMENT_ON_LINE; /**< The one after those that control has taken. */
    uint64_t events_logged SEGMENT_ON_LINE; /**< Number of the next event to log. */
    uint64_t files[EXCHANGE_FILES] SEGMENT_ON_LINE;
    exchange_seal_t log_level_seal SEGMENT_ON_LINE;
    exchange_log_level_t log_level;
    exchange_seal_t ports_seal SEGMENT_ON_LINE;
    exchange_ports_t ports;
    segment_peers_t peers[COMMAND_SOURCE_COUNT];
    segment_note_t notes[EXCHANGE_NOTES] SEGMENT_ON_LINE;
    segment_order_t order;
    segment_order_answer_t order_answer;
} segment_others_t;

/** Written by the recorder only. */
typedef struct {
    uint32_t cycles_tail;    /**< Index up to which cycles are released. */
    uint32_t cycles_removed; /**< From recordings, since the start; wraps. */
    uint32_t is_failing;     /**< 1: it cannot write. */
    uint32_t left_min;       /**< Until the disk is full; 0: no end is foreseen. */
    uint32_t beats;          /**< In the place of its row in the part of all. */
    uint32_t checkpoint_requests;
} segment_recorder_t;

/** Written by control only. */
typedef struct {
    exchange_cards_t cards;             /**< Written once, before the robot. */
    robot_t robot;                      /**< Written once, axis_count last. */
    uint32_t published SEGMENT_ON_LINE; /**< Snapshots published. */
    segment_snapshot_t snapshots[SEGMENT_SNAPSHOTS];
    uint32_t loop_sequence SEGMENT_ON_LINE;
    loop_figures_t loop;
    uint64_t stops_taken SEGMENT_ON_LINE; /**< Stop requests handed to the controller. */
    uint32_t stop_sequence SEGMENT_ON_LINE;
    answer_t stop_answer; /**< To the newest of them. */
    struct {
        uint32_t tail SEGMENT_ON_LINE; /**< Commands taken. */
        uint32_t damaged;              /**< How often the lane was found damaged. */
    } taken[COMMAND_SOURCE_COUNT];
    segment_answers_t answers[COMMAND_SOURCE_COUNT];
    uint32_t answers_lost SEGMENT_ON_LINE;
    uint32_t checkpoints_taken;
    uint32_t ends_taken;
    uint32_t events_head SEGMENT_ON_LINE; /**< Number of the next event. */
    segment_event_t events[EXCHANGE_EVENTS];
    uint32_t list SEGMENT_ON_LINE; /**< Number of the trajectory whose rows these are. */
    uint32_t row_count;
    trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];
    uint32_t cycles_head SEGMENT_ON_LINE; /**< Index of the next cycle. */
    uint32_t cycles_seen; /**< Index up to which the recorder has believably released them. */
} segment_control_t;

typedef struct {
    segment_header_t header SEGMENT_ON_PAGE;
    segment_others_t others SEGMENT_ON_PAGE;
    segment_recorder_t recorder SEGMENT_ON_PAGE;
    segment_control_t control SEGMENT_ON_PAGE;
    cycle_entry_t cycles[]; /**< Written by control, too. */
} segment_t;

/** Bytes of a segment whose lane has `cycles` entries. */
static inline size_t segment_bytes(uint32_t cycles)
{
    return offsetof(segment_t, cycles) + (cycles * sizeof(cycle_entry_t));
}

/** State of control: the commands of a lane that a stop refuses. */
typedef struct {
    uint32_t until;    /**< The commands before this number that are no stops. */
    uint32_t stop_for; /**< workphase_t of the stop that came after them. */
} exchange_refused_t;

/** A process' view of the segment. */
struct exchange {
    segment_t *segment;
    size_t size;           /**< Size of the segment, bytes. */
    int file;              /**< The creator keeps it locked while it lives. */
    uint32_t cycles;       /**< Entries of the lane of cycles. */
    uint32_t cycles_put;   /**< In control: the index of the next one. */
    uint32_t cycles_taken; /**< In the recorder: the index of the next one to take, */
    uint32_t cycles_tail;  /**< and up to which it has released them. */
    bool is_taking;        /**< These two are known. */
    exchange_refused_t refused[COMMAND_SOURCE_COUNT];
    uint32_t first_lane;                     /**< In control: the first lane of the next cycle. */
    uint32_t answered[COMMAND_SOURCE_COUNT]; /**< In each source: number of answers taken. */
    uint32_t newest_note;                    /**< In http; 0: not looked for yet. */
    uint32_t order_given;                    /**< In http: the id of its last order. */
    uint32_t order_answered;                 /**< In igtl: the id of the last order answered. */
    char name[SEGMENT_NAME_SIZE];
};

/**
 * A number that differs when the name, type or place of anything in the segment differs, or the
 * meaning of a number in it.
 */
uint64_t segment_layout(void);

#endif
