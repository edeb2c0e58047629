/* SPDX-License-Identifier: Apache-2.0 */
/** @file What a real-time process asks of the kernel, and gets. */
#ifndef BORESIGHT_REALTIME_H
#define BORESIGHT_REALTIME_H

#include <stdbool.h>
#include <stdint.h>

/**
 * Asks for SCHED_FIFO, a core of its own and locked memory.
 *
 * @return EXCHANGE_RIGHT_ bits of what was granted
 *
 * @satisfies SWR-CTRL-002
 * @satisfies SWR-LOAD-002
 */
uint32_t realtime_acquire(void);

/**
 * Gives SCHED_FIFO back, for a process that leaves no core idle.
 *
 * @satisfies SWR-BOX-043
 */
void realtime_give_way(void);

/**
 * Says on standard error, one sentence each, which rights were refused and what to do about it.
 *
 * @satisfies SWR-CTRL-002
 */
void realtime_report(uint32_t rights);

/**
 * Keeps all cores from sleeping deeply until the process ends, by the kernel's file below `root`.
 *
 * @return whether the kernel lets it
 *
 * @satisfies SWR-CHECK-007
 */
bool realtime_stay_awake(const char *root);

/** The world's monotonic time, ns. */
uint64_t realtime_now_ns(void);

/** Page faults of the calling thread since it began; those that waited for the disk are major. */
void realtime_count_faults(uint64_t *minor, uint64_t *major);

/** The core that realtime_acquire() asks for, and the number of cores. */
uint32_t realtime_core(uint32_t *cores);

#endif
