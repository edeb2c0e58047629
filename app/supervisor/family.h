/* SPDX-License-Identifier: Apache-2.0 */
/** @file The five programs of one Boresight: their command lines, their start, their restart and
 * their end. */
#ifndef BORESIGHT_FAMILY_H
#define BORESIGHT_FAMILY_H

#include "exchange/exchange.h"
#include "supervisor/child.h"
#include "supervisor/options.h"

#include <stdbool.h>
#include <stdint.h>

#define FAMILY_NAME_SIZE 48U
#define FAMILY_PATH_SIZE (OPTIONS_PATH_SIZE + FAMILY_NAME_SIZE + 16U)

/** In the order of their start. */
typedef enum {
    MEMBER_BOX = 0,
    MEMBER_CONTROL = 1,
    MEMBER_RECORDER = 2,
    MEMBER_IGTL = 3,
    MEMBER_HTTP = 4
} member_t;

#define FAMILY_SIZE 5U

typedef struct {
    child_t members[FAMILY_SIZE];
    char box[FAMILY_NAME_SIZE]; /**< Name of the box. */
    bool has_own_box;           /**< It is a member; otherwise it ran before and runs on. */
    uint32_t slowness;          /**< Of the board: control and box have as many times longer. */
    char positions[FAMILY_PATH_SIZE]; /**< File of the kept positions of this box. */
    int output;                       /**< Where their standard output and error go. */
    int errors;
} family_t;

/**
 * Makes the command lines; `options` outlives it.
 *
 * @return false, with a sentence in `error`, when a program is missing
 */
bool family_init(family_t *self, const options_t *options, int output, int errors, char *error,
                 uint32_t error_size);

/** Starts one. False with a sentence in `error`. */
bool family_start(family_t *self, member_t member, char *error, uint32_t error_size);

/** Takes note of every member that has ended. Returns one of them, or -1 when there is none (left).
 * Never waits. */
int family_reap(family_t *self);

/**
 * Starts again those whose time has come.
 *
 * @satisfies SWR-SUP-002
 */
void family_restart(family_t *self);

/** Looks at the alive counters: whether `member` has been silent for two seconds. */
bool family_is_silent(family_t *self, const exchange_t *exchange, member_t member);

/**
 * Stops igtl and http, then control, then the recorder, then the box; who does not obey in his time
 * is killed.
 *
 * @satisfies SWR-SUP-001
 */
void family_stop(family_t *self);

#endif
