/* SPDX-License-Identifier: Apache-2.0 */
/* Checks of the kernel, and of the rights that it gives. */
#include "check/check_files.h"
#include "check/check_judges.h"
#include "exchange/exchange.h"

#include <stdlib.h>
#include <string.h>

bool check_kernel(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    char says[CHECK_FILE_SIZE];
    if (check_read(facts->root, "/sys/kernel/realtime", says) && (strcmp(says, "1") == 0)) {
        return check_say(true, found, "The kernel is PREEMPT_RT.");
    }
    if (!check_read(facts->root, "/proc/version", says)) {
        return check_say(false, found, "/proc/version cannot be read.");
    }
    const bool is_real_time =
        (strstr(says, "PREEMPT_RT") != NULL) || (strstr(says, "PREEMPT RT") != NULL);
    const char *const build = strchr(says, '#');
    return check_say(is_real_time, found, "The kernel is %.120s.", (build != NULL) ? build : says);
}

bool check_throttling(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    char says[CHECK_FILE_SIZE];
    if (!check_read(facts->root, "/proc/sys/kernel/sched_rt_runtime_us", says)) {
        return check_say(false, found, "sched_rt_runtime_us cannot be read.");
    }
    return check_say(strcmp(says, "-1") == 0, found, "sched_rt_runtime_us is %.20s.", says);
}

bool check_rights(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    const bool has_priority = (facts->rights & EXCHANGE_RIGHT_FIFO) != 0U;
    const bool has_memory = (facts->rights & EXCHANGE_RIGHT_MEMORY) != 0U;
    return check_say(has_priority && has_memory, found, "Real-time priority is %s, memory is %s.",
                     has_priority ? "granted" : "refused", has_memory ? "locked" : "not locked");
}

bool check_page_faults(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    const bool has_any = (facts->minor_faults != 0U) || (facts->major_faults != 0U);
    return check_say(!has_any, found, "%llu page faults in %u cycles, %llu of them from the disk.",
                     (unsigned long long)(facts->minor_faults + facts->major_faults),
                     (unsigned)facts->cycles, (unsigned long long)facts->major_faults);
}

bool check_clock(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    static const char *const coarse[] = {"jiffies", "refined-jiffies", "hpet"};
    char says[CHECK_FILE_SIZE];
    if (!check_read(facts->root, "/sys/devices/system/clocksource/clocksource0/current_clocksource",
                    says)) {
        return check_say(false, found, "The clock source cannot be read.");
    }
    bool is_good = facts->clock_ns == 1U;
    for (size_t i = 0U; i < (sizeof coarse / sizeof coarse[0]); i++) {
        is_good = is_good && (strcmp(says, coarse[i]) != 0);
    }
    return check_say(is_good, found, "The clock source is %.40s, its steps are %llu ns.", says,
                     (unsigned long long)facts->clock_ns);
}

/* Only root may read the kernel's list; the steps of the clock show the same. */
bool check_timers(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    FILE *const file = check_open(facts->root, "/proc/timer_list");
    bool is_good = facts->clock_ns == 1U;
    char line[CHECK_FILE_SIZE];
    while ((file != NULL) && (fgets(line, (int)sizeof line, file) != NULL)) {
        if (strstr(line, "hres_active") != NULL) {
            is_good = is_good && (strstr(line, ": 1") != NULL);
        }
    }
    if (file != NULL) {
        (void)fclose(file);
    }
    return check_say(is_good, found, "High-resolution timers are %s.",
                     is_good ? "active" : "not active");
}

bool check_swap(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    FILE *const file = check_open(facts->root, "/proc/swaps");
    char line[CHECK_FILE_SIZE] = "";
    uint32_t lines = 0U;
    while ((file != NULL) && (lines < 2U) && (fgets(line, (int)sizeof line, file) != NULL)) {
        lines++;
    }
    if (file != NULL) {
        (void)fclose(file);
    }
    line[strcspn(line, " \t\n")] = '\0';
    return (lines < 2U) ? check_say(true, found, "Nothing is swapped.")
                        : check_say(false, found, "Memory is swapped to %.100s.", line);
}

/* Bit of bootstatus: the last start was by a watchdog (linux/watchdog.h). */
#define CARD_RESET 0x20UL

bool check_watchdog(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    char says[CHECK_FILE_SIZE];
    if (!check_read(facts->root, "/sys/class/watchdog/watchdog0/identity", says)) {
        return check_say(false, found, "There is no watchdog.");
    }
    char status[CHECK_FILE_SIZE];
    (void)check_read(facts->root, "/sys/class/watchdog/watchdog0/bootstatus", status);
    const bool has_bitten = (strtoul(status, NULL, 0) & CARD_RESET) != 0U;
    return check_say(!has_bitten, found,
                     has_bitten ? "The watchdog %.60s has restarted the computer."
                                : "There is the watchdog %.60s.",
                     says);
}
