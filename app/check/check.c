/* SPDX-License-Identifier: Apache-2.0 */
#include "check/check.h"

#include "check/check_judges.h"

#include <stdarg.h>
#include <stdio.h>

static check_judge_t *const judges[COMPUTER_CHECK_COUNT] = {
    [COMPUTER_CHECK_KERNEL] = check_kernel,
    [COMPUTER_CHECK_THROTTLING] = check_throttling,
    [COMPUTER_CHECK_RIGHTS] = check_rights,
    [COMPUTER_CHECK_PAGE_FAULTS] = check_page_faults,
    [COMPUTER_CHECK_OWN_CORE] = check_own_core,
    [COMPUTER_CHECK_INTERRUPTS] = check_interrupts,
    [COMPUTER_CHECK_WORK_QUEUES] = check_work_queues,
    [COMPUTER_CHECK_GOVERNOR] = check_governor,
    [COMPUTER_CHECK_IDLE] = check_idle,
    [COMPUTER_CHECK_CLOCK] = check_clock,
    [COMPUTER_CHECK_TIMERS] = check_timers,
    [COMPUTER_CHECK_SWAP] = check_swap,
    [COMPUTER_CHECK_WATCHDOG] = check_watchdog,
    [COMPUTER_CHECK_WAKE_UP] = check_wake_up,
    [COMPUTER_CHECK_BUDGET] = check_cycle_budget,
};

bool check_is_good(const check_facts_t *facts, computer_check_t check, char found[CHECK_TEXT_SIZE])
{
    return judges[check](facts, found);
}

bool check_say(bool is_good, char found[CHECK_TEXT_SIZE], const char *format, ...)
{
    va_list words;
    va_start(words, format);
    (void)vsnprintf(found, CHECK_TEXT_SIZE, format, words);
    va_end(words);
    return is_good;
}
