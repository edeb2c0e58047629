/* SPDX-License-Identifier: Apache-2.0 */
/** @file The programs of one Boresight: their command lines, their start, their restart and their
 * end. */
#ifndef BORESIGHT_FAMILY_H
#define BORESIGHT_FAMILY_H

#include "exchange/exchange.h"
#include "supervisor/child.h"
#include "supervisor/options.h"

#include <stdbool.h>
#include <stdint.h>

#define FAMILY_NAME_SIZE 96U /**< Size of a box's name, with its end. */
#define FAMILY_PATH_SIZE (OPTIONS_PATH_SIZE + FAMILY_NAME_SIZE + 16U)
#define FAMILY_TEXT_SIZE (OPTIONS_PATH_SIZE + (2U * FAMILY_NAME_SIZE))

/** In the order of their start: first the board's, as its table has them. */
typedef enum {
    MEMBER_COMPANION = 0,
    MEMBER_CONTROL = BOARD_COMPANIONS,
    MEMBER_RECORDER = MEMBER_CONTROL + 1,
    MEMBER_IGTL = MEMBER_CONTROL + 2,
    MEMBER_HTTP = MEMBER_CONTROL + 3
} member_t;

#define FAMILY_SIZE (BOARD_COMPANIONS + 4U)

typedef struct {
    child_t members[FAMILY_SIZE];        /**< The name is NULL where the board has none. */
    bool runs_already[FAMILY_SIZE];      /**< It is not ours: it ran before and runs on. */
    char box[BOARD_VALUE_SIZE];          /**< The box that control opens. */
    uint32_t slowness;                   /**< Control and companions have as many times longer. */
    char positions[FAMILY_PATH_SIZE];    /**< File of the kept positions of this box. */
    char box_key[FAMILY_PATH_SIZE + 4U]; /**< File of its key. */
    char words[BOARD_COMPANIONS][BOARD_ARGUMENTS][FAMILY_TEXT_SIZE]; /**< Their arguments. */
    int output; /**< Where their standard output and error go. */
    int errors;
} process_group_t;

/**
 * Makes the command lines; `options` outlives it.
 *
 * @return false, with a sentence in `error`, when a program is missing or a text too long
 *
 * @satisfies SWR-STORE-031
 * @satisfies SWR-SUP-006
 * @satisfies SWR-SUP-008
 */
bool process_group_init(process_group_t *self, const options_t *options, int output, int errors,
                        char *error, uint32_t error_size);

/** Starts one. False with a sentence in `error`. */
bool process_group_start(process_group_t *self, member_t member, char *error, uint32_t error_size);

/** Takes note of every member that has ended. Returns one of them, or -1 when there is none (left).
 * Never waits. */
int process_group_reap(process_group_t *self);

/**
 * Starts again those whose time has come.
 *
 * @satisfies SWR-SUP-002
 */
void process_group_restart(process_group_t *self);

/** Looks at the alive counters: whether `member` has been silent for two seconds. */
bool process_group_is_silent(process_group_t *self, const exchange_t *exchange, member_t member);

/**
 * To be called often. Looks five times a second, so that a pause of the machine is one look:
 * whether `member`, which is replaced when it hangs, has given no sign of life for LIMIT_HANG_US.
 * Then it is killed, which is noted in the exchange, and process_group_reap() finds its end.
 *
 * @satisfies SWR-LIFE-001
 */
bool process_group_end_hanging(process_group_t *self, exchange_t *exchange, member_t member);

/**
 * Stops igtl and http, then control, then the recorder, then the programs that came with the board;
 * a program that does not obey in its time is killed. The recorder finds in `exchange` whether
 * control has ended in order.
 *
 * @satisfies SWR-SUP-001
 * @satisfies SWR-SUP-013
 */
void process_group_stop(process_group_t *self, exchange_t *exchange);

#endif
