/* SPDX-License-Identifier: Apache-2.0 */
#include "check/checkup.h"

#include "check/realtime.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"

#include <errno.h>
#include <string.h>
#include <time.h>

#define NS_PER_US 1000U
#define NS_PER_S 1000000000U
#define CYCLE_NS (NS_PER_US * LIMIT_CYCLE_US)
#define BUCKETS 4096U /* Each a microsecond wide; the last one collects everything longer. */
#define PERCENT 100U
#define PER_CENT_99 99U

static uint32_t counts[BUCKETS];

static void sleep_until(uint64_t deadline_ns)
{
    const struct timespec deadline = {.tv_sec = (time_t)(deadline_ns / NS_PER_S),
                                      .tv_nsec = (long)(deadline_ns % NS_PER_S)};
    int result = EINTR;
    while (result == EINTR) {
        result = clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, NULL);
    }
}

static uint32_t p99_us(uint32_t cycles)
{
    const uint64_t wanted = (((uint64_t)cycles * PER_CENT_99) + PERCENT - 1U) / PERCENT;
    uint64_t seen = counts[0];
    uint32_t bucket = 0U;
    while ((seen < wanted) && (bucket < (BUCKETS - 1U))) {
        bucket++;
        seen += counts[bucket];
    }
    return bucket;
}

/* Each is at its own time: one that is missed is late by what it was missed by. */
static void wake_up(check_facts_t *facts, uint32_t cycles)
{
    uint64_t deadline_ns = realtime_now_ns();
    for (uint32_t i = 0U; i < cycles; i++) {
        deadline_ns += CYCLE_NS;
        sleep_until(deadline_ns);
        const uint64_t late_us = (realtime_now_ns() - deadline_ns) / NS_PER_US;
        const uint32_t bucket = (late_us < BUCKETS) ? (uint32_t)late_us : (BUCKETS - 1U);
        counts[bucket]++;
        facts->wake_worst_us =
            (late_us > facts->wake_worst_us) ? (uint32_t)late_us : facts->wake_worst_us;
    }
}

void checkup_measure(check_facts_t *facts, uint32_t cycles)
{
    struct timespec step = {.tv_nsec = 0};
    uint64_t minor = 0U;
    uint64_t major = 0U;
    facts->core = realtime_core(&facts->cores);
    facts->rights = realtime_acquire();
    facts->is_awake = !facts->is_simulated && realtime_stay_awake(facts->root);
    (void)clock_getres(CLOCK_MONOTONIC, &step);
    facts->clock_ns = ((uint64_t)step.tv_sec * NS_PER_S) + (uint64_t)step.tv_nsec;
    (void)memset(counts, 0, sizeof counts);
    facts->wake_worst_us = 0U;
    check_count_interrupts(facts->root, facts->core, facts->interrupts);
    realtime_count_faults(&minor, &major);
    wake_up(facts, cycles);
    realtime_count_faults(&facts->minor_faults, &facts->major_faults);
    facts->minor_faults -= minor;
    facts->major_faults -= major;
    facts->cycles = cycles;
    facts->wake_p99_us = p99_us(cycles);
}

int checkup_report(const check_facts_t *facts, FILE *out)
{
    uint32_t good = 0U;
    uint32_t blocking = 0U;
    for (uint32_t i = 0U; i < COMPUTER_CHECK_COUNT; i++) {
        const computer_check_t check = (computer_check_t)i;
        char found[CHECK_TEXT_SIZE];
        const bool is_good = check_is_good(facts, check, found);
        const char *const bad = check_blocks(check) ? "!!" : "no";
        (void)fprintf(out, "%s  %-12s %s\n", is_good ? "ok" : bad, computer_check_name((int32_t)i),
                      found);
        if (!is_good) {
            (void)fprintf(out, "%17s%s\n", "", computer_check_text((int32_t)i));
        }
        good += is_good ? 1U : 0U;
        blocking += (!is_good && check_blocks(check)) ? 1U : 0U;
    }
    (void)fprintf(out, "%u of %u are good", (unsigned)good, COMPUTER_CHECK_COUNT);
    if (blocking > 0U) {
        (void)fprintf(out, "; %u (!!) keep a real robot from being enabled", (unsigned)blocking);
    }
    (void)fprintf(out, ".\n");
    return (good == COMPUTER_CHECK_COUNT) ? 0 : 1;
}
