/* SPDX-License-Identifier: Apache-2.0 */
/** @file The judges of check.h's table, each of one check. Private to app/check. */
#ifndef BORESIGHT_CHECK_JUDGES_H
#define BORESIGHT_CHECK_JUDGES_H

#include "check/check_facts.h"

#include <stdbool.h>

/** As check_is_good(). */
typedef bool check_judge_t(const check_facts_t *facts, char found[CHECK_TEXT_SIZE]);

check_judge_t check_kernel;
check_judge_t check_throttling;
check_judge_t check_rights;
check_judge_t check_page_faults;
check_judge_t check_own_core;
check_judge_t check_interrupts;
check_judge_t check_work_queues;
check_judge_t check_governor;
check_judge_t check_idle;
check_judge_t check_clock;
check_judge_t check_timers;
check_judge_t check_swap;
check_judge_t check_watchdog;
check_judge_t check_wake_up;
check_judge_t check_cycle_budget;

/** Writes a sentence. @return `is_good` */
bool check_say(bool is_good, char found[CHECK_TEXT_SIZE], const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
