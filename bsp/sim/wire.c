/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/wire.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/futex.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

/* "BBX" and the layout's version. */
#define WIRE_MAGIC 0x4242580AU

#define NS_PER_S UINT64_C(1000000000)
#define BENCH_ANSWER_CLOCK_US 10000U

static const char start_first[] = "start the simulated control box first: boresight-box --box %s";

uint32_t wire_load(const uint32_t *word)
{
    return __atomic_load_n(word, __ATOMIC_ACQUIRE);
}

void wire_store(uint32_t *word, uint32_t value)
{
    __atomic_store_n(word, value, __ATOMIC_RELEASE);
}

void wire_latch(uint32_t *word, uint32_t bits)
{
    (void)__atomic_fetch_or(word, bits, __ATOMIC_SEQ_CST);
}

uint32_t wire_take(uint32_t *word)
{
    return __atomic_exchange_n(word, 0U, __ATOMIC_SEQ_CST);
}

uint64_t wire_load_time(const wire_t *wire)
{
    return __atomic_load_n(&wire->time_us, __ATOMIC_ACQUIRE);
}

void wire_store_time(wire_t *wire, uint64_t time_us)
{
    __atomic_store_n(&wire->time_us, time_us, __ATOMIC_RELEASE);
}

static void wake_sleepers(const uint32_t *word)
{
    (void)syscall(SYS_futex, word, FUTEX_WAKE, 1, NULL, NULL, 0);
}

void wire_wake_box(wire_t *wire)
{
    (void)__atomic_add_fetch(&wire->wake, 1U, __ATOMIC_ACQ_REL);
    wake_sleepers(&wire->wake);
}

void wire_announce(uint32_t *word, uint32_t value)
{
    wire_store(word, value);
    wake_sleepers(word);
}

void wire_sleep(const uint32_t *word, uint32_t value, uint32_t timeout_us)
{
    /* The kernel's own timespec, s and ns: the C library's may be wider. */
    const long timeout[2] = {(long)(timeout_us / 1000000U), (long)(timeout_us % 1000000U) * 1000L};

    (void)syscall(SYS_futex, word, FUTEX_WAIT, value, timeout, NULL, 0);
}

uint64_t wire_now_ns(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * NS_PER_S + (uint64_t)now.tv_nsec;
}

uint64_t wire_now_us(void)
{
    return wire_now_ns() / 1000U;
}

bool wire_await(const uint32_t *word, uint32_t value, uint32_t timeout_us)
{
    const uint64_t end_us = wire_now_us() + timeout_us;

    for (;;) {
        const uint32_t seen = wire_load(word);
        if (seen == value) {
            return true;
        }
        const uint64_t now_us = wire_now_us();
        if (now_us >= end_us) {
            return false;
        }
        wire_sleep(word, seen, (uint32_t)(end_us - now_us));
    }
}

bool wire_give_order(wire_t *wire, const char *order, uint32_t timeout_us)
{
    const uint32_t number = wire_load(&wire->order_request) + 1U;

    (void)snprintf(wire->order, sizeof wire->order, "%s", order);
    wire_store(&wire->order_request, number);
    wire_wake_box(wire);
    const bool is_answered = wire_await(&wire->order_reply, number, timeout_us);
    if (!is_answered) {
        wire->order[0] = '\0';
    }
    return is_answered;
}

bool wire_set_pace(wire_t *wire, uint32_t pace)
{
    const bool is_pace = (pace >= 1U) && (pace <= wire_load(&wire->speedup));

    if (is_pace) {
        wire_store(&wire->pace, pace);
    }
    return is_pace;
}

uint32_t wire_pace(const wire_t *wire)
{
    const uint32_t pace = wire_load(&wire->pace);

    return ((pace >= 1U) && (pace <= wire_load(&wire->speedup))) ? pace : 1U;
}

/* Byte by byte, as the other side may be at it. */
static void copy_shared(void *to, const void *from, size_t size)
{
    uint8_t *const bytes = to;
    const uint8_t *const shared = from;

    for (size_t i = 0U; i < size; i++) {
        __atomic_store_n(&bytes[i], __atomic_load_n(&shared[i], __ATOMIC_RELAXED),
                         __ATOMIC_RELAXED);
    }
}

/* A box that was killed in the middle has left an odd edition. */
void wire_show_bench(wire_t *wire, const bsp_bench_t *bench)
{
    const uint32_t edition = wire_load(&wire->bench_edition) | 1U;

    wire_store(&wire->bench_edition, edition);
    __atomic_thread_fence(__ATOMIC_SEQ_CST);
    copy_shared(&wire->bench, bench, sizeof wire->bench);
    wire_store(&wire->bench_edition, edition + 1U);
}

bool wire_see_bench(const wire_t *wire, bsp_bench_t *seen)
{
    const uint64_t end_us = wire_now_us() + BENCH_ANSWER_CLOCK_US;
    bool is_whole = false;

    do {
        const uint32_t edition = wire_load(&wire->bench_edition);
        copy_shared(seen, &wire->bench, sizeof *seen);
        __atomic_thread_fence(__ATOMIC_SEQ_CST);
        is_whole = ((edition & 1U) == 0U) && (wire_load(&wire->bench_edition) == edition);
    } while (!is_whole && (wire_now_us() < end_us));
    return is_whole;
}

static bool lock_end(int file, wire_end_t end)
{
    struct flock lock = {
        .l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = (off_t)end, .l_len = 1};

    return fcntl(file, F_OFD_SETLK, &lock) == 0;
}

/* A living process holds `end`. */
static bool is_held(const wire_port_t *port, wire_end_t end)
{
    struct flock lock = {
        .l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = (off_t)end, .l_len = 1};

    return (fcntl(port->file, F_OFD_GETLK, &lock) == 0) && (lock.l_type != F_UNLCK);
}

bool wire_is_served(const wire_port_t *port)
{
    return is_held(port, WIRE_END_BOX);
}

/* Control lives in the time that it found when it opened the board. */
static bool would_change_time(const wire_port_t *port, box_time_t time)
{
    return is_held(port, WIRE_END_CONTROL) &&
           (((wire_load(&port->wire->is_elastic) != 0U) != time.is_elastic) ||
            (wire_load(&port->wire->slowness) != time.slowness) ||
            (wire_load(&port->wire->speedup) != time.speedup));
}

static bool set_path(wire_port_t *port, const char *name, char *error, uint32_t error_size)
{
    const size_t length = strlen(name);

    if ((length == 0U) || (length > sizeof port->path - 2U) || (strchr(name, '/') != NULL)) {
        (void)snprintf(error, error_size,
                       "the box name \"%.70s\" must have 1 to %u characters and no slash", name,
                       (unsigned)(sizeof port->path - 2U));
        return false;
    }
    (void)snprintf(port->path, sizeof port->path, "/%s", name);
    return true;
}

static bool map_wire(wire_port_t *port)
{
    void *memory = mmap(NULL, sizeof(wire_t), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE,
                        port->file, 0);

    port->wire = (memory == MAP_FAILED) ? NULL : memory;
    return port->wire != NULL;
}

static bool has_wire_size(int file)
{
    struct stat status;

    return (fstat(file, &status) == 0) && (status.st_size == (off_t)sizeof(wire_t));
}

/* Another box may remove the name between our opening and our locking it. */
static bool is_still_named(const wire_port_t *port)
{
    struct stat ours;
    struct stat named;
    const int file = shm_open(port->path, O_RDONLY, 0);
    bool is_same = false;

    if (file >= 0) {
        is_same = (fstat(port->file, &ours) == 0) && (fstat(file, &named) == 0) &&
                  (ours.st_ino == named.st_ino);
        (void)close(file);
    }
    return is_same;
}

/* A wire of another layout is of no use to anyone: its name is given to a new one. */
static bool size_wire(wire_port_t *port)
{
    struct stat status;

    if (fstat(port->file, &status) != 0) {
        return false;
    }
    if ((status.st_size != 0) && (status.st_size != (off_t)sizeof(wire_t))) {
        (void)shm_unlink(port->path);
        (void)close(port->file);
        port->file = shm_open(port->path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if ((port->file < 0) || !lock_end(port->file, WIRE_END_BOX)) {
            return false;
        }
    }
    return ftruncate(port->file, (off_t)sizeof(wire_t)) == 0;
}

/* Never 0. */
static uint32_t new_power_on(void)
{
    uint32_t id = 0U;

    while (id == 0U) {
        (void)!getrandom(&id, sizeof id, 0U);
    }
    return id;
}

static void reset_wire(wire_t *wire, box_time_t time)
{
    /* Counters and time live on, so that an attached control process finds its next request
     * answered. */
    wire_store(&wire->inputs, 0U);
    wire_store(&wire->is_elastic, time.is_elastic ? 1U : 0U);
    wire_store(&wire->slowness, time.slowness);
    wire_store(&wire->speedup, time.speedup);
    wire_store(&wire->pace, time.speedup);
    wire_store(&wire->power_on, new_power_on());
    wire_store(&wire->is_used, 0U);
    wire_store(&wire->come, wire_load(&wire->call));
    wire_store(&wire->reply, wire_load(&wire->request));
    wire_store(&wire->order_reply, wire_load(&wire->order_request));
    wire_store(&wire->magic, WIRE_MAGIC);
}

bool wire_serve(wire_port_t *port, const char *name, box_time_t time, char *error,
                uint32_t error_size)
{
    port->wire = NULL;
    if (!set_path(port, name, error, error_size)) {
        return false;
    }
    port->file = shm_open(port->path, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (port->file < 0) {
        (void)snprintf(error, error_size, "cannot make the shared memory %s: %s", port->path,
                       strerror(errno));
        return false;
    }
    if (!lock_end(port->file, WIRE_END_BOX)) {
        (void)snprintf(
            error, error_size,
            "a simulated control box \"%s\" already runs; stop it, or choose another --box", name);
    } else if (!is_still_named(port)) {
        (void)snprintf(error, error_size,
                       "a simulated control box \"%s\" is just ending; start again", name);
    } else if (!size_wire(port) || !map_wire(port)) {
        (void)snprintf(error, error_size, "cannot map the shared memory %s: %s", port->path,
                       strerror(errno));
    } else if (would_change_time(port, time)) {
        (void)snprintf(
            error, error_size,
            "the control process of \"%s\" lives in another time; stop it first, or give "
            "--slow, --fast and --real-time as before",
            name);
    } else {
        reset_wire(port->wire, time);
        return true;
    }
    /* A mapping would keep the file, and with it the lock. */
    if (port->wire != NULL) {
        (void)munmap(port->wire, sizeof(wire_t));
        port->wire = NULL;
    }
    if (port->file >= 0) {
        (void)close(port->file);
    }
    return false;
}

static bool take_end(const wire_port_t *port, wire_end_t end)
{
    const uint32_t tries = (end == WIRE_END_ORDERS) ? 200U : 1U;
    const struct timespec pause = {0, 5000000};

    for (uint32_t i = 0U; i < tries; i++) {
        if ((end == WIRE_END_NONE) || lock_end(port->file, end)) {
            return true;
        }
        if (i + 1U < tries) {
            (void)nanosleep(&pause, NULL);
        }
    }
    return false;
}

bool wire_attach(wire_port_t *port, const char *name, wire_end_t end, char *error,
                 uint32_t error_size)
{
    port->wire = NULL;
    if (!set_path(port, name, error, error_size)) {
        return false;
    }
    port->file = shm_open(port->path, O_RDWR | O_CLOEXEC, 0);
    if (port->file < 0) {
        (void)snprintf(error, error_size, start_first, name);
        return false;
    }
    if (!wire_is_served(port)) {
        (void)snprintf(error, error_size, start_first, name);
    } else if (!has_wire_size(port->file) || !map_wire(port) ||
               (wire_load(&port->wire->magic) != WIRE_MAGIC)) {
        (void)snprintf(
            error, error_size,
            "the simulated control box \"%s\" is of another build or not ready; start it again",
            name);
    } else if (!take_end(port, end)) {
        (void)snprintf(error, error_size,
                       "another process already uses the simulated control box \"%s\"; stop it",
                       name);
    } else {
        return true;
    }
    wire_close(port, end);
    return false;
}

void wire_close(wire_port_t *port, wire_end_t end)
{
    if ((end == WIRE_END_BOX) && (port->wire != NULL)) {
        (void)shm_unlink(port->path);
    }
    if (port->wire != NULL) {
        (void)munmap(port->wire, sizeof(wire_t));
        port->wire = NULL;
    }
    (void)close(port->file);
}
