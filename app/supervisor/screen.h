/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The operator's view: lines, and below them one line of status. On a terminal it is rewritten
 * in place, as wide as the terminal at most and coloured unless NO_COLOR is set; elsewhere it is
 * whole, and repeated. The programs' own lines come in through pipes and stand above it.
 */
#ifndef BORESIGHT_SCREEN_H
#define BORESIGHT_SCREEN_H

#include "supervisor/status_parts.h"

#include <stdbool.h>
#include <stdint.h>

#define SCREEN_LINE_SIZE 1024U

typedef struct {
    int output[2]; /**< Pipe of the programs' standard output: only looked at for `awaited`. */
    int errors[2]; /**< Pipe of their standard error: shown. */
    bool is_terminal;
    bool is_coloured;
    const char *awaited;           /**< Line that one of the programs is to print; NULL: none. */
    bool is_heard;                 /**< It has. */
    status_repeat_t repeat;        /**< Where it is no terminal. */
    char status[SCREEN_LINE_SIZE]; /**< On the terminal now; "" when none. */
} screen_t;

/** Makes the pipes. False with errno set. */
bool screen_open(screen_t *self);

/** Shows one line. */
void screen_say(screen_t *self, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Listens from now on for `text` on the programs' standard output; NULL counts as heard. */
void screen_await(screen_t *self, const char *text);

/** Shows what the programs have said. Never waits. */
void screen_relay(screen_t *self);

/** Shows the status line. @satisfies SWR-SUP-004 */
void screen_show_status(screen_t *self, const status_parts_t *status, uint64_t now_us);

/** Takes the status line away before the last lines. */
void screen_end_status(screen_t *self);

#endif
