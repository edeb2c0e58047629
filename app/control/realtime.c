/* SPDX-License-Identifier: Apache-2.0 */
#include "control/realtime.h"

#include "exchange/exchange.h"

#include <sched.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#define CONTROL_PRIORITY 80

static uint32_t acquire_priority(void)
{
    const struct sched_param parameter = {.sched_priority = CONTROL_PRIORITY};
    if (sched_setscheduler(0, SCHED_FIFO, &parameter) == 0) {
        return EXCHANGE_RIGHT_FIFO;
    }
    (void)fprintf(stderr, "control: no real-time priority; run as root or allow it with "
                          "'ulimit -r 80'. In real time cycles may be late.\n");
    return 0;
}

static uint32_t acquire_core(void)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    cpu_set_t set;
    CPU_ZERO(&set);
    if (cores > 1) {
        CPU_SET((size_t)cores - 1U, &set);
        if (sched_setaffinity(0, sizeof set, &set) == 0) {
            return EXCHANGE_RIGHT_CORE;
        }
    }
    (void)fprintf(stderr, "control: no core of its own; use a machine with at least two cores.\n");
    return 0;
}

static uint32_t acquire_memory(void)
{
    if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) {
        return EXCHANGE_RIGHT_MEMORY;
    }
    (void)fprintf(stderr, "control: memory is not locked; run as root or allow it with "
                          "'ulimit -l unlimited'. In real time cycles may be late.\n");
    return 0;
}

uint32_t realtime_acquire(void)
{
    return acquire_priority() | acquire_core() | acquire_memory();
}

uint64_t realtime_now_ns(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((uint64_t)now.tv_sec * UINT64_C(1000000000)) + (uint64_t)now.tv_nsec;
}
