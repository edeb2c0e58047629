/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The computer's own watchdog (/dev/watchdog): it restarts a computer that stands still, and so
 * takes the power of the drives. It does not stop a motor in time; the watchdogs of the cards do.
 */
#ifndef BORESIGHT_KERNEL_WATCHDOG_H
#define BORESIGHT_KERNEL_WATCHDOG_H

#include <stdbool.h>
#include <stdint.h>

/** An armed watchdog. */
typedef struct {
    int file; /**< -1: there is none. */
    uint64_t kicked_ns;
} kernel_watchdog_t;

/** None. */
void kernel_watchdog_init(kernel_watchdog_t *self);

/**
 * Arms the watchdog at `path`, which from now on wants to be kicked every `timeout_s`.
 *
 * @return false: `error` holds one sentence that says what to do
 *
 * @satisfies SWR-GPIO-007
 */
bool kernel_watchdog_arm(kernel_watchdog_t *self, const char *path, uint32_t timeout_s, char *error,
                         uint32_t error_size);

/** Kicks it, at most ten times a second. */
void kernel_watchdog_kick(kernel_watchdog_t *self, uint64_t now_ns);

/**
 * Lets it go: with `is_safe` it is disarmed, if the kernel lets anybody; otherwise it will bite.
 *
 * @satisfies SWR-GPIO-007
 */
void kernel_watchdog_release(kernel_watchdog_t *self, bool is_safe);

#endif
