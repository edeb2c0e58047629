/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * cards-on-spi DEVICE BOX: a character device /dev/DEVICE that answers as the kernel's spidev does.
 * Behind it are the cards of the simulated box BOX, on a multiplexer with all slots. For the
 * emulated machine alone, whose SPI leads to nothing: a program that opens the device sees no
 * difference. A program of the user serves it by CUSE, so that a request has its data fetched in
 * rounds.
 */
#define FUSE_USE_VERSION 31
#include "bsp.h"

#include <fuse3/cuse_lowlevel.h>
#include <errno.h>
#include <fuse3/fuse_lowlevel.h>
#include <linux/spi/spidev.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>

#define NAME_SIZE 64
#define SETTINGS 8U
#define EVERY_SLOT ((1U << CARD_SLOT_COUNT) - 1U)
/* In the box's time, which may pass a hundred times slower. */
#define TIMEOUT_NS UINT64_C(50000000)
/* As prompt as a wire: before the box and whatever is not in real time. */
#define PRIORITY 75

typedef struct spi_ioc_transfer transfer_t;

static uint32_t settings[SETTINGS]; /* By the number of their requests. */
static uint32_t next_slot;          /* Next slot of the multiplexer. */
static uint8_t sent[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
static uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];

static void open_device(fuse_req_t request, struct fuse_file_info *file)
{
    (void)fuse_reply_open(request, file);
}

/* Mode, bits and clock: kept, and read back as they were set. */
static void take_setting(fuse_req_t request, unsigned command, void *argument, const void *in,
                         size_t in_size, size_t out_size)
{
    const size_t size = _IOC_SIZE(command);
    const struct iovec place = {argument, size};
    const bool is_set = (_IOC_DIR(command) & _IOC_WRITE) != 0U;

    if ((_IOC_NR(command) >= SETTINGS) || (size > sizeof settings[0])) {
        (void)fuse_reply_err(request, EINVAL);
    } else if ((is_set ? in_size : out_size) < size) {
        (void)fuse_reply_ioctl_retry(request, &place, is_set ? 1U : 0U, &place, is_set ? 0U : 1U);
    } else if (is_set) {
        (void)memcpy(&settings[_IOC_NR(command)], in, size);
        (void)fuse_reply_ioctl(request, 0, NULL, 0U);
    } else {
        (void)fuse_reply_ioctl(request, 0, &settings[_IOC_NR(command)], size);
    }
}

/* Whole frames at the clock that was set, the chip select released between them. */
static bool is_right(const transfer_t *transfers, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        if ((transfers[i].len != CARD_FRAME_BYTES) ||
            (transfers[i].speed_hz != settings[_IOC_NR(SPI_IOC_WR_MAX_SPEED_HZ)]) ||
            ((transfers[i].cs_change != 0U) != ((i + 1U) < count))) {
            return false;
        }
    }
    return true;
}

/* Where the descriptors say that the frames are, in the memory of who asks. */
static void fetch_frames(fuse_req_t request, const struct iovec *descriptors,
                         const transfer_t *transfers, uint32_t count)
{
    struct iovec in[CARD_SLOT_COUNT + 1U] = {*descriptors};
    struct iovec out[CARD_SLOT_COUNT];

    for (uint32_t i = 0U; i < count; i++) {
        in[i + 1U] =
            (struct iovec){(void *)(uintptr_t)transfers[i].tx_buf, (size_t)transfers[i].len};
        out[i] = (struct iovec){(void *)(uintptr_t)transfers[i].rx_buf, (size_t)transfers[i].len};
    }
    (void)fuse_reply_ioctl_retry(request, in, count + 1U, out, count);
}

/* A message of several frames begins with the first slot, single ones go round. A slot without a
 * card gives zeros. */
static bool exchange(const uint8_t *frames, uint32_t count)
{
    bsp_exchange_t result;

    next_slot = (count > 1U) ? 0U : (next_slot % CARD_SLOT_COUNT);
    (void)memset(received, 0, sizeof received);
    (void)memcpy(sent[next_slot], frames, (size_t)count * CARD_FRAME_BYTES);
    bsp_start((EVERY_SLOT >> (CARD_SLOT_COUNT - count)) << next_slot,
              (const uint8_t(*)[CARD_FRAME_BYTES])sent);
    bsp_finish(bsp_now_ns() + TIMEOUT_NS, received, &result);
    return result.results[next_slot] <= (uint8_t)BSP_SLOT_NO_ANSWER;
}

static void transfer(fuse_req_t request, unsigned command, void *argument, const uint8_t *in,
                     size_t in_size)
{
    const struct iovec descriptors = {argument, _IOC_SIZE(command)};
    const uint32_t count = (uint32_t)(_IOC_SIZE(command) / sizeof(transfer_t));
    const size_t bytes = (size_t)count * CARD_FRAME_BYTES;
    transfer_t transfers[CARD_SLOT_COUNT];

    if ((count == 0U) || (count > CARD_SLOT_COUNT)) {
        (void)fuse_reply_err(request, EMSGSIZE);
        return;
    }
    if (in_size == 0U) {
        (void)fuse_reply_ioctl_retry(request, &descriptors, 1U, NULL, 0U);
        return;
    }
    (void)memcpy(transfers, in, descriptors.iov_len);
    if (!is_right(transfers, count)) {
        (void)fuse_reply_err(request, EINVAL);
    } else if (in_size == descriptors.iov_len) {
        fetch_frames(request, &descriptors, transfers, count);
    } else if (!exchange(&in[descriptors.iov_len], count)) {
        (void)fuse_reply_err(request, EIO);
    } else {
        (void)fuse_reply_ioctl(request, (int)bytes, received[next_slot], bytes);
        next_slot += count;
    }
}

static void obey(fuse_req_t request, int command, void *argument, struct fuse_file_info *file,
                 unsigned flags, const void *in, size_t in_size, size_t out_size)
{
    (void)file;
    (void)flags;
    if (_IOC_TYPE((unsigned)command) != SPI_IOC_MAGIC) {
        (void)fuse_reply_err(request, ENOTTY);
    } else if (_IOC_NR((unsigned)command) == 0U) {
        transfer(request, (unsigned)command, argument, in, in_size);
    } else {
        take_setting(request, (unsigned)command, argument, in, in_size, out_size);
    }
}

int main(int count, char *words[])
{
    const struct sched_param parameter = {.sched_priority = PRIORITY};
    static const struct cuse_lowlevel_ops operations = {.open = open_device, .ioctl = obey};
    char *own[] = {words[0], "-f", "-s", NULL};
    char name[NAME_SIZE];
    const char *device[] = {name};
    const struct cuse_info info = {
        .dev_info_argc = 1U, .dev_info_argv = device, .flags = CUSE_UNRESTRICTED_IOCTL};
    bsp_identity_t identity;
    char error[256] = "call it with DEVICE and BOX";

    if ((count != 3) || !bsp_open(words[2], &identity, error, sizeof error)) {
        (void)fprintf(stderr, "cards-on-spi: %s\n", error);
        return EXIT_FAILURE;
    }
    (void)sched_setscheduler(0, SCHED_FIFO, &parameter);
    (void)snprintf(name, sizeof name, "DEVNAME=%s", words[1]);
    return cuse_lowlevel_main(3, own, &info, &operations, NULL);
}
