/* SPDX-License-Identifier: Apache-2.0 */
#include "sbrio/kernel_watchdog.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/watchdog.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#define KICK_NS UINT64_C(100000000)

void kernel_watchdog_init(kernel_watchdog_t *self)
{
    *self = (kernel_watchdog_t){.file = -1};
}

bool kernel_watchdog_arm(kernel_watchdog_t *self, const char *path, uint32_t timeout_s, char *error,
                         uint32_t error_size)
{
    int seconds = (int)timeout_s;

    self->file = open(path, O_WRONLY | O_CLOEXEC);
    if (self->file < 0) {
        (void)snprintf(error, error_size,
                       "The watchdog %s cannot be opened (%s); end who uses it, or leave it out.",
                       path, strerror(errno));
        return false;
    }
    if ((ioctl(self->file, WDIOC_SETTIMEOUT, &seconds) != 0) || (seconds != (int)timeout_s)) {
        (void)snprintf(error, error_size,
                       "The watchdog %s does not take a timeout of %u s; choose another.", path,
                       (unsigned)timeout_s);
        kernel_watchdog_release(self, true);
        return false;
    }
    return true;
}

void kernel_watchdog_kick(kernel_watchdog_t *self, uint64_t now_ns)
{
    if ((self->file >= 0) && ((now_ns - self->kicked_ns) >= KICK_NS)) {
        (void)!write(self->file, "k", 1U);
        self->kicked_ns = now_ns;
    }
}

void kernel_watchdog_release(kernel_watchdog_t *self, bool is_safe)
{
    if (self->file >= 0) {
        if (is_safe) {
            (void)!write(self->file, "V", 1U);
        }
        (void)close(self->file);
        self->file = -1;
    }
}
