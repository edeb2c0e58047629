/* SPDX-License-Identifier: Apache-2.0 */
#include "check/realtime.h"

#include "exchange/exchange.h"

#include <fcntl.h>
#include <limits.h>
#include <sched.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#define CONTROL_PRIORITY 80

static uint32_t acquire_priority(void)
{
    const struct sched_param parameter = {.sched_priority = CONTROL_PRIORITY};
    return (sched_setscheduler(0, SCHED_FIFO, &parameter) == 0) ? EXCHANGE_RIGHT_FIFO : 0U;
}

static uint32_t acquire_core(void)
{
    uint32_t cores = 0U;
    const uint32_t core = realtime_core(&cores);
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(core, &set);
    const bool is_granted = (cores > 1U) && (sched_setaffinity(0, sizeof set, &set) == 0);
    return is_granted ? EXCHANGE_RIGHT_CORE : 0U;
}

static uint32_t acquire_memory(void)
{
    return (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) ? EXCHANGE_RIGHT_MEMORY : 0U;
}

uint32_t realtime_acquire(void)
{
    return acquire_priority() | acquire_core() | acquire_memory();
}

void realtime_give_way(void)
{
    const struct sched_param parameter = {.sched_priority = 0};

    (void)sched_setscheduler(0, SCHED_OTHER, &parameter);
    (void)prctl(PR_SET_TIMERSLACK, 1000UL, 0UL, 0UL, 0UL);
}

void realtime_report(uint32_t rights)
{
    if ((rights & EXCHANGE_RIGHT_FIFO) == 0U) {
        (void)fprintf(stderr, "control: no real-time priority; run as root or allow it with "
                              "'ulimit -r 80'. In real time cycles may be late.\n");
    }
    if ((rights & EXCHANGE_RIGHT_CORE) == 0U) {
        (void)fprintf(stderr,
                      "control: no core of its own; use a machine with at least two cores.\n");
    }
    if ((rights & EXCHANGE_RIGHT_MEMORY) == 0U) {
        (void)fprintf(stderr, "control: memory is not locked; run as root or allow it with "
                              "'ulimit -l unlimited'. In real time cycles may be late.\n");
    }
}

bool realtime_stay_awake(const char *root)
{
    const int32_t latency_us = 0;
    char path[PATH_MAX];

    (void)snprintf(path, sizeof path, "%s/dev/cpu_dma_latency", root);
    const int file = open(path, O_WRONLY | O_CLOEXEC); /* Holds as long as it is open. */
    return (file >= 0) && (write(file, &latency_us, sizeof latency_us) == sizeof latency_us);
}

uint64_t realtime_now_ns(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((uint64_t)now.tv_sec * UINT64_C(1000000000)) + (uint64_t)now.tv_nsec;
}

void realtime_count_faults(uint64_t *minor, uint64_t *major)
{
    struct rusage usage;

    (void)getrusage(RUSAGE_THREAD, &usage);
    *minor = (uint64_t)usage.ru_minflt;
    *major = (uint64_t)usage.ru_majflt;
}

uint32_t realtime_core(uint32_t *cores)
{
    const long online = sysconf(_SC_NPROCESSORS_ONLN);

    *cores = (online > 0) ? (uint32_t)online : 1U;
    return *cores - 1U;
}
