/* SPDX-License-Identifier: Apache-2.0 */
#include "sbrio/spi_bus.h"

#include "limits/requirement_limits.h"

#include <linux/futex.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#define NS_PER_S UINT64_C(1000000000)
#define NS_PER_US UINT64_C(1000)
#define REST_NS (NS_PER_US * LIMIT_SPI_REST_US)
#define CLOSE_NS (NS_PER_S / 5U)
#define STACK_BYTES 131072U
#define CLOCK_STEP_HZ 100000U
#define CLOCK_MOST_HZ 100000000U

uint64_t spi_bus_now_ns(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((uint64_t)now.tv_sec * NS_PER_S) + (uint64_t)now.tv_nsec;
}

static struct timespec time_of(uint64_t time_ns)
{
    return (struct timespec){.tv_sec = (time_t)(time_ns / NS_PER_S),
                             .tv_nsec = (long)(time_ns % NS_PER_S)};
}

uint32_t spi_bus_time_us(const wiring_t *wiring, uint32_t number)
{
    uint32_t time_us = 0U;
    for (uint32_t i = 0U; i < wiring->spi_count; i++) {
        if (wiring->spi[i].bus == number) {
            time_us += spi_device_time_us(&wiring->spi[i]);
        }
    }
    return time_us;
}

uint32_t spi_bus_clock_needed_hz(const wiring_t *wiring, uint32_t number, uint32_t time_us)
{
    wiring_t faster = *wiring;
    for (uint32_t clock_hz = CLOCK_STEP_HZ; clock_hz <= CLOCK_MOST_HZ; clock_hz += CLOCK_STEP_HZ) {
        for (uint32_t i = 0U; i < faster.spi_count; i++) {
            faster.spi[i].clock_hz = clock_hz;
        }
        if (spi_bus_time_us(&faster, number) <= time_us) {
            return clock_hz;
        }
    }
    return 0U;
}

/* A multiplexer may stand anywhere after an exchange that failed or was interrupted for long. */
static void rest(const spi_bus_t *self)
{
    const struct timespec rested = time_of(self->finished_ns + REST_NS);

    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &rested, NULL) != 0) {
    }
}

static void transfer(spi_bus_t *self)
{
    if (self->needs_rest) {
        rest(self);
    }
    const uint64_t started_ns = spi_bus_now_ns();
    self->needs_rest = false;
    for (uint32_t i = 0U; i < self->device_count; i++) {
        spi_device_t *const device = &self->devices[i];
        const uint32_t gap_us =
            (self->gap_us > device->wiring.gap_us) ? self->gap_us : device->wiring.gap_us;
        spi_device_transfer(device, gap_us, self->sent, self->received, self->sampled_ns);
        self->needs_rest = self->needs_rest || (device->error != 0);
    }
    self->finished_ns = spi_bus_now_ns();
    self->needs_rest = self->needs_rest || ((self->finished_ns - started_ns) >= REST_NS);
}

static void *run(void *bus)
{
    spi_bus_t *const self = bus;

    for (;;) {
        const uint32_t requested = __atomic_load_n(&self->requested, __ATOMIC_ACQUIRE);
        if (__atomic_load_n(&self->is_ending, __ATOMIC_ACQUIRE) != 0U) {
            return NULL;
        }
        if (requested == self->done) {
            (void)syscall(SYS_futex, &self->requested, FUTEX_WAIT_PRIVATE, requested, NULL);
        } else {
            transfer(self);
            __atomic_store_n(&self->done, requested, __ATOMIC_RELEASE);
            (void)syscall(SYS_futex, &self->done, FUTEX_WAKE_PRIVATE, 1, NULL);
        }
    }
}

/* The thread of control handles signals. */
static int begin(spi_bus_t *self, const pthread_attr_t *attributes)
{
    sigset_t all;
    sigset_t before;

    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_SETMASK, &all, &before);
    const int reason = pthread_create(&self->thread, attributes, run, self);
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    return reason;
}

/* Without the right to a priority it is a thread like any other. */
static bool begin_thread(spi_bus_t *self, int priority)
{
    const struct sched_param parameter = {.sched_priority = priority};
    pthread_attr_t attributes;

    (void)pthread_attr_init(&attributes);
    (void)pthread_attr_setstacksize(&attributes, STACK_BYTES);
    (void)pthread_attr_setschedpolicy(&attributes, SCHED_FIFO);
    (void)pthread_attr_setschedparam(&attributes, &parameter);
    (void)pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
    int reason = begin(self, &attributes);
    if (reason != 0) {
        (void)pthread_attr_setinheritsched(&attributes, PTHREAD_INHERIT_SCHED);
        reason = begin(self, &attributes);
    }
    (void)pthread_attr_destroy(&attributes);
    return reason == 0;
}

static void close_devices(spi_bus_t *self)
{
    for (uint32_t i = 0U; i < self->device_count; i++) {
        spi_device_close(&self->devices[i]);
    }
    self->device_count = 0U;
}

bool spi_bus_open(spi_bus_t *self, const wiring_t *wiring, uint32_t number, int priority,
                  char *error, uint32_t error_size)
{
    (void)memset(self, 0, sizeof *self);
    self->number = number;
    self->finished_ns = spi_bus_now_ns();
    self->needs_rest = true;
    for (uint32_t i = 0U; i < wiring->spi_count; i++) {
        if (wiring->spi[i].bus != number) {
            continue;
        }
        if (!spi_device_open(&self->devices[self->device_count], &wiring->spi[i], error,
                             error_size)) {
            close_devices(self);
            return false;
        }
        self->device_count++;
        self->slots |= spi_device_slots(&wiring->spi[i]);
    }
    if (!begin_thread(self, priority)) {
        (void)snprintf(error, error_size,
                       "There is no room for one more thread; end other programs.");
        close_devices(self);
        return false;
    }
    return true;
}

bool spi_bus_start(spi_bus_t *self, uint32_t send,
                   const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES], uint32_t gap_us)
{
    if (__atomic_load_n(&self->done, __ATOMIC_ACQUIRE) != self->requested) {
        return false;
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((send & (1U << slot)) != 0U) {
            (void)memcpy(self->sent[slot], frames[slot], CARD_FRAME_BYTES);
        } else {
            (void)memset(self->sent[slot], 0, CARD_FRAME_BYTES);
        }
    }
    self->gap_us = gap_us;
    __atomic_store_n(&self->requested, self->requested + 1U, __ATOMIC_RELEASE);
    (void)syscall(SYS_futex, &self->requested, FUTEX_WAKE_PRIVATE, 1, NULL);
    return true;
}

bool spi_bus_await(const spi_bus_t *self, uint64_t deadline_ns)
{
    for (;;) {
        const uint32_t done = __atomic_load_n(&self->done, __ATOMIC_ACQUIRE);
        const uint64_t now_ns = spi_bus_now_ns();
        if ((done == self->requested) || (now_ns >= deadline_ns)) {
            return done == self->requested;
        }
        const struct timespec timeout = time_of(deadline_ns - now_ns);
        (void)syscall(SYS_futex, &self->done, FUTEX_WAIT_PRIVATE, done, &timeout);
    }
}

int32_t spi_bus_error(const spi_bus_t *self, uint32_t slot)
{
    int32_t error = 0;
    for (uint32_t i = 0U; i < self->device_count; i++) {
        if ((spi_device_slots(&self->devices[i].wiring) & (1U << slot)) != 0U) {
            error = self->devices[i].error;
        }
    }
    return error;
}

void spi_bus_close(spi_bus_t *self)
{
    const bool is_idle = spi_bus_await(self, spi_bus_now_ns() + CLOSE_NS);

    __atomic_store_n(&self->is_ending, 1U, __ATOMIC_RELEASE);
    __atomic_store_n(&self->requested, self->requested + 1U, __ATOMIC_RELEASE);
    (void)syscall(SYS_futex, &self->requested, FUTEX_WAKE_PRIVATE, 1, NULL);
    if (is_idle) {
        (void)pthread_join(self->thread, NULL);
        close_devices(self);
    } else {
        (void)pthread_detach(self->thread);
    }
}
