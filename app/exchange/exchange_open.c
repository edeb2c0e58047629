/* SPDX-License-Identifier: Apache-2.0 */
#include "exchange/exchange.h"
#include "exchange/exchange_segment.h"

#include "interface/interface_layout.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define SEGMENT_MODE 0600
#define SMALLEST_PAGE 4096U

uint64_t segment_layout(void)
{
    return INTERFACE_LAYOUT ^ (uint64_t)segment_bytes(1U);
}

static bool set_name(exchange_t *self, const char *name, char *error, uint32_t error_size)
{
    const int length = snprintf(self->name, sizeof self->name, "/%s", name);
    const bool is_good = (name[0] != '\0') && (strchr(name, '/') == NULL) && (length > 0) &&
                         ((size_t)length < sizeof self->name);

    if (!is_good) {
        (void)snprintf(error, error_size,
                       "\"%s\" cannot name an exchange; use 1 to %u characters without a slash.",
                       name, SEGMENT_NAME_SIZE - 2U);
    }
    return is_good;
}

/* Removes what a dead creator left behind. A living one holds the lock. */
static bool remove_stale(const exchange_t *self, char *error, uint32_t error_size)
{
    const int file = shm_open(self->name, O_RDWR, 0);

    if (file < 0) {
        return true;
    }
    const bool is_stale = (flock(file, LOCK_EX | LOCK_NB) == 0);
    if (is_stale) {
        (void)shm_unlink(self->name);
    } else {
        (void)snprintf(error, error_size,
                       "Boresight already runs with the name \"%s\"; end it or choose another name "
                       "with --instance.",
                       &self->name[1]);
    }
    (void)close(file);
    return is_stale;
}

static bool create_file(exchange_t *self, char *error, uint32_t error_size)
{
    if (!remove_stale(self, error, error_size)) {
        return false;
    }
    self->file = shm_open(self->name, O_RDWR | O_CREAT | O_EXCL, SEGMENT_MODE);
    if (self->file < 0) {
        (void)snprintf(error, error_size,
                       "The exchange %s cannot be created (%s); check the rights of /dev/shm.",
                       self->name, strerror(errno));
        return false;
    }
    (void)flock(self->file, LOCK_EX | LOCK_NB);
    /* Allocated now, so that a full /dev/shm is a sentence here and not a SIGBUS in the control
     * loop. */
    const int result = posix_fallocate(self->file, 0, (off_t)self->size);
    if (result != 0) {
        (void)snprintf(error, error_size,
                       "/dev/shm has no room for %zu MiB (%s); free some or mount it larger.",
                       (self->size >> 20) + 1U, strerror(result));
        (void)shm_unlink(self->name);
        return false;
    }
    return true;
}

static bool map(exchange_t *self, char *error, uint32_t error_size)
{
    void *address = mmap(NULL, self->size, PROT_READ | PROT_WRITE, MAP_SHARED, self->file, 0);

    if (address == MAP_FAILED) {
        (void)snprintf(error, error_size,
                       "The exchange %s cannot be mapped (%s); free some memory.", self->name,
                       strerror(errno));
        return false;
    }
    self->segment = address;
    return true;
}

static bool refuse_size(const exchange_t *self, char *error, uint32_t error_size)
{
    (void)snprintf(error, error_size,
                   "The exchange %s has the size of another build; run programs of one build only.",
                   self->name);
    return false;
}

static bool open_file(exchange_t *self, char *error, uint32_t error_size)
{
    struct stat status;

    self->file = shm_open(self->name, O_RDWR, 0);
    if (self->file < 0) {
        (void)snprintf(error, error_size,
                       "There is no exchange %s (%s); start the program boresight first.",
                       self->name, strerror(errno));
        return false;
    }
    const bool is_known = fstat(self->file, &status) == 0;
    self->size = is_known ? (size_t)status.st_size : 0U;
    if ((self->size < segment_bytes(1U)) || (self->size > segment_bytes(EXCHANGE_CYCLES_MOST))) {
        return refuse_size(self, error, error_size);
    }
    return true;
}

static bool check_header(const exchange_t *self, char *error, uint32_t error_size)
{
    const segment_header_t *header = &self->segment->header;

    if (__atomic_load_n(&header->magic, __ATOMIC_ACQUIRE) != SEGMENT_MAGIC) {
        (void)snprintf(error, error_size, "%s is not an exchange of Boresight; remove /dev/shm%s.",
                       self->name, self->name);
        return false;
    }
    if (header->layout != segment_layout()) {
        (void)snprintf(
            error, error_size,
            "The exchange %s has the layout of another build; run programs of one build only.",
            self->name);
        return false;
    }
    return (self->size == segment_bytes(header->cycles)) || refuse_size(self, error, error_size);
}

static exchange_t *discard(exchange_t *self)
{
    if (self->segment != NULL) {
        (void)munmap(self->segment, self->size);
    }
    if (self->file >= 0) {
        (void)close(self->file);
    }
    free(self);
    return NULL;
}

static exchange_t *allocate(char *error, uint32_t error_size)
{
    exchange_t *self = calloc(1U, sizeof *self);

    if (self == NULL) {
        (void)snprintf(error, error_size, "There is no memory left; end other programs.");
    } else {
        self->file = -1;
    }
    return self;
}

static uint64_t now_utc_us(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_REALTIME, &now);
    return ((uint64_t)now.tv_sec * UINT64_C(1000000)) + ((uint64_t)now.tv_nsec / 1000U);
}

exchange_t *exchange_create(const char *name, uint32_t cycles, char *error, uint32_t error_size)
{
    exchange_t *self = allocate(error, error_size);

    if (self == NULL) {
        return NULL;
    }
    self->cycles = cycles;
    self->size = segment_bytes(cycles);
    if (!set_name(self, name, error, error_size) || !create_file(self, error, error_size)) {
        return discard(self);
    }
    if (!map(self, error, error_size)) {
        (void)shm_unlink(self->name);
        return discard(self);
    }
    self->segment->header.layout = segment_layout();
    self->segment->header.cycles = cycles;
    self->segment->header.run = now_utc_us();
    __atomic_store_n(&self->segment->header.magic, SEGMENT_MAGIC, __ATOMIC_RELEASE);
    return self;
}

bool exchange_is_used(const char *name)
{
    exchange_t self;
    char error[1];

    if (!set_name(&self, name, error, sizeof error)) {
        return false;
    }
    const int file = shm_open(self.name, O_RDWR, 0);
    if (file < 0) {
        return errno != ENOENT;
    }
    const bool is_used = flock(file, LOCK_SH | LOCK_NB) != 0;
    (void)close(file);
    return is_used;
}

exchange_t *exchange_open(const char *name, char *error, uint32_t error_size)
{
    exchange_t *self = allocate(error, error_size);

    if (self == NULL) {
        return NULL;
    }
    if (!set_name(self, name, error, error_size) || !open_file(self, error, error_size) ||
        !map(self, error, error_size) || !check_header(self, error, error_size)) {
        return discard(self);
    }
    (void)close(self->file);
    self->file = -1;
    for (uint32_t i = 0U; i < COMMAND_SOURCE_COUNT; i++) {
        self->answered[i] =
            __atomic_load_n(&self->segment->control.answers[i].head, __ATOMIC_ACQUIRE);
    }
    self->cycles = self->segment->header.cycles;
    const uint32_t put = __atomic_load_n(&self->segment->control.cycles_head, __ATOMIC_ACQUIRE);
    self->cycles_put = (put < (2U * self->cycles)) ? put : 0U;
    return self;
}

/* From what control writes to the end. */
static size_t size_of_control(const exchange_t *self)
{
    return self->size - offsetof(segment_t, control);
}

void exchange_protect(exchange_t *self, exchange_process_t process)
{
    (void)mprotect(&self->segment->header, sizeof self->segment->header, PROT_READ);
    (void)mprotect(&self->segment->control, size_of_control(self), PROT_READ);
    if (process != EXCHANGE_RECORDER) {
        (void)mprotect(&self->segment->recorder, sizeof self->segment->recorder, PROT_READ);
    }
}

uint64_t exchange_run(const exchange_t *self)
{
    return self->segment->header.run;
}

void exchange_note_control_ended(exchange_t *self)
{
    __atomic_store_n(&self->segment->header.control_ended, 1U, __ATOMIC_RELEASE);
}

bool exchange_has_control_ended(const exchange_t *self)
{
    return __atomic_load_n(&self->segment->header.control_ended, __ATOMIC_ACQUIRE) != 0U;
}

void exchange_touch(exchange_t *self)
{
    volatile uint8_t *const bytes = (volatile uint8_t *)&self->segment->control;

    for (size_t at = 0U; at < size_of_control(self); at += SMALLEST_PAGE) {
        const uint8_t byte = bytes[at];
        bytes[at] = byte;
    }
}

void exchange_close(exchange_t *self)
{
    if (self->file >= 0) {
        (void)shm_unlink(self->name);
    }
    (void)discard(self);
}
