/* SPDX-License-Identifier: Apache-2.0 */
/* Checks of the loop's core: that it is left to the loop. */
#include "check/check.h"
#include "check/check_files.h"
#include "check/check_judges.h"

#include <stdlib.h>
#include <string.h>

#define PATH_SIZE 128U
#define IDLE_STATES 10U
#define IDLE_WORST_US 10U
#define DECIMAL 10

/* The list of isolcpus=, after its flags; "" without one. */
static const char *isolated_by(const char *command_line)
{
    const char *const option = strstr(command_line, "isolcpus=");
    return (option != NULL) ? strpbrk(option, "0123456789 ") : NULL;
}

bool check_own_core(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    char list[CHECK_FILE_SIZE];
    char line[CHECK_FILE_SIZE];
    (void)check_read(facts->root, "/sys/devices/system/cpu/isolated", list);
    (void)check_read(facts->root, "/proc/cmdline", line);
    const char *const booted = isolated_by(line);
    const bool is_isolated = check_list_has(list, facts->core) ||
                             ((booted != NULL) && check_list_has(booted, facts->core));
    if (facts->cores < 2U) {
        return check_say(false, found, "There is one core only.");
    }
    return check_say(is_isolated, found, "Core %u of %u is %s.", (unsigned)facts->core,
                     (unsigned)facts->cores, is_isolated ? "isolated" : "not isolated");
}

/* How often it has come to `core`, of the columns after its number; the rest of the line is its
 * name. */
static uint64_t count_of(char *line, uint32_t core, uint64_t *all, const char **name)
{
    uint64_t counted = 0U;
    uint32_t column = 0U;
    char *next = line;
    char *end = NULL;
    *all = 0U;
    for (uint64_t count = strtoull(next, &end, DECIMAL);
         (end != next) && ((*end == ' ') || (*end == '\n'));
         count = strtoull(next, &end, DECIMAL)) {
        counted = (column == core) ? count : counted;
        *all += count;
        column++;
        next = end;
    }
    char *const last = strrchr(next, ' ');
    next[strcspn(next, "\n")] = '\0';
    *name = (last != NULL) ? (last + 1) : next;
    return counted;
}

/* The number of a device's interrupt; CHECK_INTERRUPTS where the line is none. */
static uint32_t number_of(char *line, char **counts)
{
    const unsigned long number = strtoul(line, counts, DECIMAL);
    const bool is_one = (*counts != line) && (**counts == ':') && (number < CHECK_INTERRUPTS);
    *counts += is_one ? 1 : 0;
    return is_one ? (uint32_t)number : CHECK_INTERRUPTS;
}

void check_count_interrupts(const char *root, uint32_t core, uint64_t counts[CHECK_INTERRUPTS])
{
    FILE *const file = check_open(root, "/proc/interrupts");
    char line[CHECK_FILE_SIZE];
    (void)memset(counts, 0, CHECK_INTERRUPTS * sizeof counts[0]);
    while ((file != NULL) && (fgets(line, (int)sizeof line, file) != NULL)) {
        char *rest = NULL;
        const char *name = NULL;
        uint64_t all = 0U;
        const uint32_t number = number_of(line, &rest);
        if (number < CHECK_INTERRUPTS) {
            counts[number] = count_of(rest, core, &all, &name);
        }
    }
    if (file != NULL) {
        (void)fclose(file);
    }
}

/* Where it comes; the kernel may choose among those where it may. */
static bool may_come(const check_facts_t *facts, uint32_t number)
{
    static const char *const files[] = {"effective_affinity_list", "smp_affinity_list"};
    char list[CHECK_FILE_SIZE] = "";
    for (size_t i = 0U; (i < 2U) && (list[0] == '\0'); i++) {
        char path[PATH_SIZE];
        (void)snprintf(path, sizeof path, "/proc/irq/%u/%s", (unsigned)number, files[i]);
        (void)check_read(facts->root, path, list);
    }
    return check_list_has(list, facts->core);
}

/* Each core of an ARM has its own timer, which stands among the devices and comes nowhere else. */
static bool is_timer_of_core(const char *name)
{
    static const char *const names[] = {"twd", "gt", "arch_timer"};
    bool is_one = false;
    for (size_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        is_one = is_one || (strcmp(name, names[i]) == 0);
    }
    return is_one;
}

/* Judges one line of /proc/interrupts. */
static bool is_elsewhere(const check_facts_t *facts, char *line, char found[CHECK_TEXT_SIZE])
{
    char *rest = NULL;
    const char *name = NULL;
    uint64_t all = 0U;
    const uint32_t number = number_of(line, &rest);
    if (number >= CHECK_INTERRUPTS) {
        return true;
    }
    const uint64_t came = count_of(rest, facts->core, &all, &name) - facts->interrupts[number];
    if (is_timer_of_core(name)) {
        return true;
    }
    if (came != 0U) {
        return check_say(false, found, "Interrupt %u (%.60s) has come %llu times to core %u.",
                         (unsigned)number, name, (unsigned long long)came, (unsigned)facts->core);
    }
    return (all == 0U) || !may_come(facts, number) ||
           check_say(false, found, "Interrupt %u (%.60s) may come to core %u.", (unsigned)number,
                     name, (unsigned)facts->core);
}

bool check_interrupts(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    FILE *const file = check_open(facts->root, "/proc/interrupts");
    char line[CHECK_FILE_SIZE];
    bool is_good = file != NULL;
    if (!is_good) {
        return check_say(false, found, "/proc/interrupts cannot be read.");
    }
    while (is_good && (fgets(line, (int)sizeof line, file) != NULL)) {
        is_good = is_elsewhere(facts, line, found);
    }
    (void)fclose(file);
    if (!is_good) {
        return false;
    }
    const bool may_new_ones = check_read(facts->root, "/proc/irq/default_smp_affinity", line) &&
                              check_mask_has(line, facts->core);
    return check_say(!may_new_ones, found,
                     may_new_ones ? "New interrupts may come to core %u (default_smp_affinity)."
                                  : "No device interrupts core %u.",
                     (unsigned)facts->core);
}

bool check_work_queues(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    char mask[CHECK_FILE_SIZE];
    if (!check_read(facts->root, "/sys/devices/virtual/workqueue/cpumask", mask)) {
        return check_say(false, found, "The work queues' mask cannot be read.");
    }
    const bool has_it = check_mask_has(mask, facts->core);
    return check_say(!has_it, found, "Core %u is %s the work queues' mask %.60s.",
                     (unsigned)facts->core, has_it ? "in" : "not in", mask);
}

bool check_governor(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    char path[PATH_SIZE];
    char says[CHECK_FILE_SIZE];
    (void)snprintf(path, sizeof path, "/sys/devices/system/cpu/cpu%u/cpufreq/scaling_governor",
                   (unsigned)facts->core);
    if (!check_read(facts->root, path, says)) {
        return check_say(true, found, "The clock of core %u has no governor.",
                         (unsigned)facts->core);
    }
    return check_say(strcmp(says, "performance") == 0, found, "The governor of core %u is %.40s.",
                     (unsigned)facts->core, says);
}

static uint32_t idle_number(const check_facts_t *facts, uint32_t state, const char *name)
{
    char path[PATH_SIZE];
    char says[CHECK_FILE_SIZE];
    (void)snprintf(path, sizeof path, "/sys/devices/system/cpu/cpu%u/cpuidle/state%u/%s",
                   (unsigned)facts->core, (unsigned)state, name);
    (void)check_read(facts->root, path, says);
    return (uint32_t)strtoul(says, NULL, DECIMAL);
}

bool check_idle(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    uint32_t worst_us = 0U;
    for (uint32_t i = 0U; i < IDLE_STATES; i++) {
        const uint32_t latency_us =
            (idle_number(facts, i, "disable") == 0U) ? idle_number(facts, i, "latency") : 0U;
        worst_us = (latency_us > worst_us) ? latency_us : worst_us;
    }
    return check_say(facts->is_awake || (worst_us < IDLE_WORST_US), found,
                     "Core %u wakes from its deepest sleep in %u us%s.", (unsigned)facts->core,
                     (unsigned)worst_us, facts->is_awake ? "; control keeps it awake" : "");
}
