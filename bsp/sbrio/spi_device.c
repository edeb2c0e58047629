/* SPDX-License-Identifier: Apache-2.0 */
#include "sbrio/spi_device.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/spi/spidev.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#define BITS_PER_WORD 8U
#define FRAME_BITS UINT64_C(2048)
/* The kernel's pause of the chip select between frames, and a system call with its interrupts. */
#define PAUSE_US 10U
#define CALL_US 20U
#define NS_PER_S UINT64_C(1000000000)
#define KERNEL_LIMIT "/sys/module/spidev/parameters/bufsiz"

uint32_t spi_device_slots(const wiring_spi_t *wiring)
{
    return ((1U << wiring->slot_count) - 1U) << wiring->first_slot;
}

uint32_t spi_device_time_us(const wiring_spi_t *wiring)
{
    const uint64_t wire_us =
        ((FRAME_BITS * wiring->slot_count * UINT64_C(1000000)) + wiring->clock_hz - 1U) /
        wiring->clock_hz;
    const uint32_t pauses_us = (wiring->gap_us == 0U)
                                   ? (CALL_US + (PAUSE_US * wiring->slot_count))
                                   : ((CALL_US + wiring->gap_us) * wiring->slot_count);

    return (uint32_t)wire_us + pauses_us;
}

static bool set_mode(const spi_device_t *self, char *error, uint32_t error_size)
{
    uint8_t mode = (uint8_t)self->wiring.mode;
    uint8_t bits = BITS_PER_WORD;

    if ((ioctl(self->file, SPI_IOC_WR_MODE, &mode) != 0) ||
        (ioctl(self->file, SPI_IOC_WR_BITS_PER_WORD, &bits) != 0) ||
        (ioctl(self->file, SPI_IOC_RD_MODE, &mode) != 0) ||
        (ioctl(self->file, SPI_IOC_RD_BITS_PER_WORD, &bits) != 0)) {
        (void)snprintf(error, error_size,
                       "%s does not take mode %u with 8 bits (%s); choose another mode=.",
                       self->wiring.path, (unsigned)self->wiring.mode, strerror(errno));
        return false;
    }
    /* 0 means 8 to the kernel. */
    if ((mode != self->wiring.mode) || ((bits != BITS_PER_WORD) && (bits != 0U))) {
        (void)snprintf(error, error_size,
                       "%s has mode %u with %u bits after mode %u with 8 bits was set; choose "
                       "another mode=, or mend its entry in the device tree.",
                       self->wiring.path, (unsigned)mode, (unsigned)bits,
                       (unsigned)self->wiring.mode);
        return false;
    }
    return true;
}

static bool set_clock(const spi_device_t *self, char *error, uint32_t error_size)
{
    uint32_t clock_hz = self->wiring.clock_hz;

    if ((ioctl(self->file, SPI_IOC_WR_MAX_SPEED_HZ, &clock_hz) != 0) ||
        (ioctl(self->file, SPI_IOC_RD_MAX_SPEED_HZ, &clock_hz) != 0)) {
        (void)snprintf(error, error_size, "%s does not take a clock of %u Hz (%s); choose another.",
                       self->wiring.path, (unsigned)self->wiring.clock_hz, strerror(errno));
        return false;
    }
    if (clock_hz != self->wiring.clock_hz) {
        (void)snprintf(error, error_size,
                       "%s has a clock of %u Hz after %u Hz were set; choose one that it can have.",
                       self->wiring.path, (unsigned)clock_hz, (unsigned)self->wiring.clock_hz);
        return false;
    }
    return true;
}

/* The kernel takes only so many bytes in one message. A kernel without such a file has no such
 * limit. */
static bool fits_kernel(const spi_device_t *self, char *error, uint32_t error_size)
{
    const unsigned needed =
        CARD_FRAME_BYTES * ((self->wiring.gap_us == 0U) ? self->wiring.slot_count : 1U);
    unsigned limit = needed;
    FILE *const file = fopen(KERNEL_LIMIT, "re");

    if (file != NULL) {
        if (fscanf(file, "%9u", &limit) != 1) {
            limit = needed;
        }
        (void)fclose(file);
    }
    if (limit < needed) {
        (void)snprintf(error, error_size,
                       "The kernel takes %u bytes in one SPI message, and %s needs %u; boot with "
                       "spidev.bufsiz=4096.",
                       limit, self->wiring.path, needed);
    }
    return limit >= needed;
}

bool spi_device_open(spi_device_t *self, const wiring_spi_t *wiring, char *error,
                     uint32_t error_size)
{
    *self = (spi_device_t){.wiring = *wiring};
    self->file = open(wiring->path, O_RDWR | O_CLOEXEC);
    if (self->file < 0) {
        (void)snprintf(error, error_size,
                       "The SPI device %s cannot be opened (%s); load spidev, check the device "
                       "tree and the rights of this user.",
                       wiring->path, strerror(errno));
        return false;
    }
    if (!set_mode(self, error, error_size) || !set_clock(self, error, error_size) ||
        !fits_kernel(self, error, error_size)) {
        spi_device_close(self);
        return false;
    }
    return true;
}

/* @return errno; 0: all went over the wire */
static int32_t send_message(const spi_device_t *self, struct spi_ioc_transfer *transfers,
                            uint32_t count)
{
    const unsigned long request =
        _IOC(_IOC_WRITE, SPI_IOC_MAGIC, 0, count * sizeof(struct spi_ioc_transfer));

    transfers[count - 1U].cs_change = 0U;
    const int size = ioctl(self->file, request, transfers);
    if (size < 0) {
        return errno;
    }
    return ((uint32_t)size == (count * CARD_FRAME_BYTES)) ? 0 : EIO;
}

/* The frames of a message follow each other at once. */
static void note_times(const spi_device_t *self, uint32_t slot, uint32_t count,
                       uint64_t sampled_ns[CARD_SLOT_COUNT])
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    const uint64_t now_ns = ((uint64_t)now.tv_sec * NS_PER_S) + (uint64_t)now.tv_nsec;
    const uint64_t frame_ns = (FRAME_BITS * NS_PER_S) / self->wiring.clock_hz;
    for (uint32_t i = 0U; i < count; i++) {
        sampled_ns[slot + i] = now_ns + (i * frame_ns);
    }
}

static void pause_us(uint32_t time_us)
{
    const struct timespec pause = {.tv_nsec = (long)time_us * 1000L};

    (void)clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, NULL);
}

void spi_device_transfer(spi_device_t *self, uint32_t gap_us,
                         uint8_t sent[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                         uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                         uint64_t sampled_ns[CARD_SLOT_COUNT])
{
    struct spi_ioc_transfer transfers[CARD_SLOT_COUNT];
    const uint32_t count = self->wiring.slot_count;

    (void)memset(transfers, 0, sizeof transfers);
    for (uint32_t i = 0U; i < count; i++) {
        const uint32_t slot = self->wiring.first_slot + i;
        transfers[i].tx_buf = (uintptr_t)sent[slot];
        transfers[i].rx_buf = (uintptr_t)received[slot];
        transfers[i].len = CARD_FRAME_BYTES;
        transfers[i].speed_hz = self->wiring.clock_hz;
        transfers[i].bits_per_word = (uint8_t)BITS_PER_WORD;
        transfers[i].cs_change = 1U;
    }
    if (gap_us == 0U) {
        note_times(self, self->wiring.first_slot, count, sampled_ns);
        self->error = send_message(self, transfers, count);
        return;
    }
    self->error = 0;
    for (uint32_t i = 0U; (i < count) && (self->error == 0); i++) {
        note_times(self, self->wiring.first_slot + i, 1U, sampled_ns);
        self->error = send_message(self, &transfers[i], 1U);
        pause_us(gap_us);
    }
}

void spi_device_close(spi_device_t *self)
{
    (void)close(self->file);
    self->file = -1;
}
