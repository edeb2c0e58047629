/* SPDX-License-Identifier: Apache-2.0 */
/** @file One program that the supervisor runs. */
#ifndef BORESIGHT_CHILD_H
#define BORESIGHT_CHILD_H

#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

#define CHILD_ARGUMENTS 18U
#define CHILD_PATH_SIZE 640U
#define CHILD_BACKOFF_FIRST_US UINT64_C(200000)
#define CHILD_BACKOFF_MOST_US UINT64_C(5000000)
/** Having run that long, the next restart comes quickly again. */
#define CHILD_STEADY_US UINT64_C(10000000)

typedef struct {
    const char *name;
    char path[CHILD_PATH_SIZE];
    const char *arguments[CHILD_ARGUMENTS]; /**< Without the program; ended by NULL. */
    bool may_restart;                       /**< Started again when it ends unasked. */
    pid_t pid;                              /**< 0: not running. */
    int status;                             /**< Status from waitpid(), when it has ended. */
    uint64_t started_us;
    uint64_t restart_us; /**< When to start it again; 0: not planned. */
    uint64_t backoff_us;
    uint32_t beats;     /**< Alive counter when last looked at. */
    uint64_t beaten_us; /**< When it last changed. */
    uint32_t heard;     /**< Alive counter at the last look for a hang. */
    uint32_t looks;     /**< Since it changed. */
    uint64_t looked_us; /**< The last one. */
} child_t;

/**
 * Starts the program with `output` and `errors` as its standard output and error. It ends when the
 * supervisor ends.
 *
 * @return false with errno set
 */
bool child_start(child_t *self, int output, int errors, uint64_t now_us);

/** Takes note of its end and plans its restart where it may. */
void child_ended(child_t *self, int status, uint64_t now_us);

/** How it ended: "exit code 3", "signal 9 (Killed)". */
void child_describe_end(const child_t *self, char *text, uint32_t size);

#endif
