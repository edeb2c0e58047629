/* SPDX-License-Identifier: Apache-2.0 */
/** @file What a real-time process asks of the kernel. */
#ifndef BORESIGHT_REALTIME_H
#define BORESIGHT_REALTIME_H

#include <stdint.h>

/**
 * Asks for SCHED_FIFO, a core of its own and locked memory. Says on standard error, one sentence
 * each, what was refused and what to do about it.
 *
 * @return EXCHANGE_RIGHT_ bits of what was granted
 *
 * @satisfies SWR-CTRL-002
 * @satisfies SWR-LOAD-002
 */
uint32_t realtime_acquire(void);

/** The world's monotonic time, ns. */
uint64_t realtime_now_ns(void);

#endif
