/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The demands of the control loop on its computer, as one table: each check reads the files of the
 * kernel or a measured value, judges it, and states its finding in a sentence. The trouble behind a
 * finding and its remedy stand in core/interface/computer_checks.yml.
 */
#ifndef BORESIGHT_CHECK_H
#define BORESIGHT_CHECK_H

#include "check/check_facts.h"
#include "interface/computer_check.h"

#include <stdbool.h>
#include <stdint.h>

/** Durations of the parts of a cycle. */
typedef struct {
    uint32_t wake_us;
    uint32_t words_us;
    uint32_t step_us;
    uint32_t publish_us;
    uint32_t wire_us; /**< Beside what is published, and the sleep. */
} check_budget_t;

/**
 * Judges. `found` receives a sentence, of what is good as well.
 *
 * @return whether it is good
 *
 * @satisfies SWR-CHECK-001
 * @satisfies SWR-CHECK-002
 * @satisfies SWR-CHECK-011
 */
bool check_is_good(const check_facts_t *facts, computer_check_t check, char found[CHECK_TEXT_SIZE]);

/** A real board refuses to be enabled while `check` is not good. */
static inline bool check_blocks(computer_check_t check)
{
    return ((COMPUTER_CHECKS_BLOCKING >> (uint32_t)check) & 1U) != 0U;
}

/** How often each interrupt has come to core `core`. */
void check_count_interrupts(const char *root, uint32_t core, uint64_t counts[CHECK_INTERRUPTS]);

/**
 * The parts of a cycle with `cards` cards whose wake-up is as late as it may be, on a board that
 * says what it costs.
 *
 * @satisfies SWR-CHECK-004
 * @satisfies SWR-CHECK-009
 */
check_budget_t check_budget(const check_board_t *board, uint32_t cards);

#endif
