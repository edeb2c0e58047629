/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the computer lacks for a punctual loop. Control owns one. */
#ifndef BORESIGHT_COMPUTER_H
#define BORESIGHT_COMPUTER_H

#include "interface/loop_figures.h"

#include <stdint.h>

typedef struct {
    uint32_t lacks; /**< Bits of computer_check_t. */
    uint64_t minor_faults;
    uint64_t major_faults; /**< Both of this thread, at the last look. */
    uint32_t looks; /**< Calls of computer_report_wake_up(), up to the one after its report. */
} computer_t;

/**
 * Checks what stays as it is, before the first cycle, and says on standard error what is not good.
 * `root`: where /proc and /sys are; `rights`: EXCHANGE_RIGHT_ bits.
 *
 * @satisfies SWR-LOOP-007
 */
void computer_begin(computer_t *self, const char *root, uint32_t rights);

/**
 * Once a second, from the loop's thread: page faults since the time before. Those since the start
 * are added up in `published`, beside what the computer lacks now.
 *
 * @satisfies SWR-LOOP-008
 */
void computer_look(computer_t *self, loop_figures_t *published);

/**
 * Once a second, after computer_look(): in the second that completes LIMIT_START_LOOK_S it says on
 * standard error how late the loop woke up until then, and whether it can be expected to keep its
 * cycle. Says nothing in elastic time, where nothing can be late.
 *
 * @satisfies SWR-LOOP-012
 */
void computer_report_wake_up(computer_t *self, const loop_figures_t *published);

#endif
