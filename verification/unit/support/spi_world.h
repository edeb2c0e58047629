/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * SPI devices of the kernel with simulated cards behind them, and a watchdog: umockdev answers
 * their ioctls, in a thread of its own. A device of several slots has a multiplexer, which leads to
 * the next slot whenever the chip select is released, and to the first one after a rest.
 */
#ifndef BORESIGHT_SPI_WORLD_H
#define BORESIGHT_SPI_WORLD_H

#include "card/card_frame.h"
#include "robot/robot.h"
#include "sim/model/sim_card.h"
#include "sim/model/sim_encoder.h"

#include <errno.h>
#include <linux/spi/spidev.h>
#include <linux/watchdog.h>
#include <semaphore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <umockdev.h>
#include <unistd.h>

#define SPI_WORLD_DEVICES 3U

/* One device. */
typedef struct {
    unsigned first_slot;
    unsigned slot_count;
    unsigned next; /* How many slots further the multiplexer leads. */
    unsigned char mode;
    unsigned char bits;
    unsigned clock_hz;
    unsigned messages; /* So many went over the wire. */
    unsigned frames;
} spi_world_device_t;

/* Faults, set by a test before the board asks. */
typedef struct {
    unsigned long refused;  /* Request that fails with EINVAL. */
    unsigned forced_mode;   /* 1 + the mode that a device always has; 0: none. */
    unsigned forced_bits;   /* The same. */
    unsigned clock_most_hz; /* 0: any. */
    int error;              /* Error of transfers; -1: they are cut short. */
    bool hangs;             /* Until `released` is posted. */
    bool needs_gap;         /* Only the first frame of a message is understood. */
    unsigned late_bits;     /* Late bits of answers. */
    unsigned shift_slots;   /* By so many slots the wires are exchanged. */
    bool repeats;           /* The cards say the same for ever. */
    bool flickers;          /* They answer every other time. */
    unsigned damaged_byte;  /* 0: none. */
    int timeout_s;          /* That the watchdog always has; 0: any. */
} spi_world_wrong_t;

static UMockdevTestbed *spi_world_bed;
static spi_world_device_t spi_world_devices[SPI_WORLD_DEVICES];
static spi_world_wrong_t spi_world_wrong;
static sem_t spi_world_released;
static sim_card_t spi_world_cards[CARD_SLOT_COUNT];
static sim_encoder_t spi_world_encoders[CARD_SLOT_COUNT];
static bool spi_world_has[CARD_SLOT_COUNT];
static char spi_world_kicks[16]; /* Bytes written to the watchdog. */
static unsigned char spi_world_said[CARD_SLOT_COUNT][CARD_FRAME_BYTES]; /* If they repeat. */

/* The calls of a program are only caught if the library was loaded before all others. */
__attribute__((constructor)) static void spi_world_preload(int count, char *arguments[])
{
    (void)count;
    if (getenv("BORESIGHT_SPI_WORLD") == NULL) {
        (void)setenv("BORESIGHT_SPI_WORLD", "1", 1);
        (void)setenv("LD_PRELOAD", "libumockdev-preload.so.0", 1);
        (void)setenv("ASAN_OPTIONS", "verify_asan_link_order=0", 0);
        (void)execv("/proc/self/exe", arguments);
    }
}

static inline unsigned long long spi_world_now_ns(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((unsigned long long)now.tv_sec * 1000000000U) + (unsigned long long)now.tv_nsec;
}

static inline void spi_world_delay(unsigned char bytes[CARD_FRAME_BYTES], unsigned bits)
{
    unsigned carried = 0U;
    for (unsigned i = 0U; (i < CARD_FRAME_BYTES) && (bits != 0U); i++) {
        const unsigned byte = bytes[i];
        bytes[i] = (unsigned char)((byte >> bits) | carried);
        carried = (byte << (8U - bits)) & 0xFFU;
    }
}

/* Answer of the card behind a slot to a frame. */
static inline void spi_world_answer(unsigned slot, bool is_understood,
                                    const unsigned char sent[CARD_FRAME_BYTES],
                                    unsigned char answer[CARD_FRAME_BYTES])
{
    const unsigned card = (slot + spi_world_wrong.shift_slots) % CARD_SLOT_COUNT;

    (void)memset(answer, 0, CARD_FRAME_BYTES);
    if (!spi_world_has[card] || (spi_world_wrong.flickers && (rand() % 2 == 0))) {
        return;
    }
    if (!is_understood) {
        (void)memset(answer, 0x5A, CARD_FRAME_BYTES);
        return;
    }
    if (!spi_world_wrong.repeats || (spi_world_said[card][0] == 0U)) {
        sim_card_report(&spi_world_cards[card], &spi_world_encoders[card], spi_world_said[card]);
    }
    sim_card_receive(&spi_world_cards[card], sent);
    (void)memcpy(answer, spi_world_said[card], CARD_FRAME_BYTES);
    if (spi_world_wrong.damaged_byte != 0U) {
        answer[spi_world_wrong.damaged_byte] ^= 0x10U;
    }
    spi_world_delay(answer, spi_world_wrong.late_bits);
}

/* One frame of a message: its buffers are the program's. */
static inline bool spi_world_frame(spi_world_device_t *device, UMockdevIoctlData *message,
                                   unsigned place, unsigned count)
{
    const gsize at = place * sizeof(struct spi_ioc_transfer);
    struct spi_ioc_transfer transfer;
    unsigned char answer[CARD_FRAME_BYTES];
    guint8 *bytes = NULL;
    gint size = 0;

    umockdev_ioctl_data_retrieve(message, &bytes, &size);
    (void)memcpy(&transfer, &bytes[at], sizeof transfer);
    g_free(bytes);
    if ((transfer.len != CARD_FRAME_BYTES) || (transfer.speed_hz != device->clock_hz) ||
        ((transfer.cs_change != 0U) != ((place + 1U) < count))) {
        return false;
    }
    UMockdevIoctlData *const sent = umockdev_ioctl_data_resolve(
        message, at + G_STRUCT_OFFSET(struct spi_ioc_transfer, tx_buf), transfer.len, NULL);
    UMockdevIoctlData *const received = umockdev_ioctl_data_resolve(
        message, at + G_STRUCT_OFFSET(struct spi_ioc_transfer, rx_buf), transfer.len, NULL);
    umockdev_ioctl_data_retrieve(sent, &bytes, &size);
    spi_world_answer(device->first_slot + device->next, !spi_world_wrong.needs_gap || (place == 0U),
                     bytes, answer);
    g_free(bytes);
    umockdev_ioctl_data_update(received, 0U, answer, sizeof answer);
    umockdev_ioctl_data_unref(sent);
    umockdev_ioctl_data_unref(received);
    device->next++;
    device->frames++;
    return true;
}

/* @return what the call of the program returns, or less than zero its error */
static inline long spi_world_message(spi_world_device_t *device, UMockdevIoctlData *argument,
                                     unsigned long request)
{
    const unsigned count = (unsigned)(_IOC_SIZE(request) / sizeof(struct spi_ioc_transfer));
    bool is_good = true;

    if (spi_world_wrong.hangs) {
        (void)sem_wait(&spi_world_released);
    }
    if (spi_world_wrong.error > 0) {
        return -spi_world_wrong.error;
    }
    device->next = (count > 1U) ? 0U : (device->next % device->slot_count);
    UMockdevIoctlData *const message =
        umockdev_ioctl_data_resolve(argument, 0U, _IOC_SIZE(request), NULL);
    for (unsigned i = 0U; (i < count) && is_good; i++) {
        is_good = spi_world_frame(device, message, i, count);
    }
    umockdev_ioctl_data_unref(message);
    device->messages++;
    return is_good ? (long)((count * CARD_FRAME_BYTES) + ((spi_world_wrong.error < 0) ? -1 : 0))
                   : -EBADMSG;
}

/* Copies a setting in or out of the program. */
static inline long spi_world_setting(UMockdevIoctlData *argument, unsigned long request,
                                     void *setting)
{
    UMockdevIoctlData *const data =
        umockdev_ioctl_data_resolve(argument, 0U, _IOC_SIZE(request), NULL);
    if ((_IOC_DIR(request) & _IOC_WRITE) != 0U) {
        guint8 *bytes = NULL;
        gint size = 0;
        umockdev_ioctl_data_retrieve(data, &bytes, &size);
        (void)memcpy(setting, bytes, (size_t)size);
        g_free(bytes);
    } else {
        umockdev_ioctl_data_update(data, 0U, setting, (gint)_IOC_SIZE(request));
    }
    umockdev_ioctl_data_unref(data);
    return 0;
}

static inline long spi_world_request(spi_world_device_t *device, UMockdevIoctlData *argument,
                                     unsigned long request)
{
    unsigned char mode = (spi_world_wrong.forced_mode != 0U)
                             ? (unsigned char)(spi_world_wrong.forced_mode - 1U)
                             : device->mode;
    unsigned char bits = (spi_world_wrong.forced_bits != 0U)
                             ? (unsigned char)(spi_world_wrong.forced_bits - 1U)
                             : device->bits;
    const unsigned most_hz = spi_world_wrong.clock_most_hz;
    unsigned clock_hz =
        ((most_hz != 0U) && (device->clock_hz > most_hz)) ? most_hz : device->clock_hz;

    switch (request) {
    case SPI_IOC_WR_MODE:
        return spi_world_setting(argument, request, &device->mode);
    case SPI_IOC_RD_MODE:
        return spi_world_setting(argument, request, &mode);
    case SPI_IOC_WR_BITS_PER_WORD:
        return spi_world_setting(argument, request, &device->bits);
    case SPI_IOC_RD_BITS_PER_WORD:
        return spi_world_setting(argument, request, &bits);
    case SPI_IOC_WR_MAX_SPEED_HZ:
        return spi_world_setting(argument, request, &device->clock_hz);
    case SPI_IOC_RD_MAX_SPEED_HZ:
        return spi_world_setting(argument, request, &clock_hz);
    default:
        return spi_world_message(device, argument, request);
    }
}

static inline gboolean spi_world_ioctl(UMockdevIoctlBase *handler, UMockdevIoctlClient *client,
                                       gpointer device)
{
    const gulong request = umockdev_ioctl_client_get_request(client);
    UMockdevIoctlData *const argument = umockdev_ioctl_client_get_arg(client);
    const long result = (request == spi_world_wrong.refused)
                            ? -EINVAL
                            : spi_world_request(device, argument, request);
    (void)handler;
    umockdev_ioctl_client_complete(client, (result < 0) ? -1 : result,
                                   (result < 0) ? (gint)-result : 0);
    return TRUE;
}

static inline gboolean spi_world_watchdog(UMockdevIoctlBase *handler, UMockdevIoctlClient *client,
                                          gpointer unused)
{
    const gulong request = umockdev_ioctl_client_get_request(client);
    UMockdevIoctlData *const data =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0U, sizeof(int), NULL);
    (void)handler;
    (void)unused;
    if (spi_world_wrong.timeout_s != 0) {
        umockdev_ioctl_data_update(data, 0U, (guint8 *)&spi_world_wrong.timeout_s, sizeof(int));
    }
    umockdev_ioctl_data_unref(data);
    const bool is_refused = (request != WDIOC_SETTIMEOUT) || (request == spi_world_wrong.refused);
    umockdev_ioctl_client_complete(client, is_refused ? -1 : 0, is_refused ? EINVAL : 0);
    return TRUE;
}

static inline gboolean spi_world_kick(UMockdevIoctlBase *handler, UMockdevIoctlClient *client,
                                      gpointer unused)
{
    const size_t used = strlen(spi_world_kicks);
    guint8 *bytes = NULL;
    gint size = 0;
    (void)handler;
    (void)unused;
    umockdev_ioctl_data_retrieve(umockdev_ioctl_client_get_arg(client), &bytes, &size);
    spi_world_kicks[used] = (used < (sizeof spi_world_kicks - 1U)) ? (char)bytes[0] : '\0';
    g_free(bytes);
    umockdev_ioctl_client_complete(client, size, 0);
    return TRUE;
}

static inline void spi_world_add(const char *name, const char *subsystem, GCallback callback,
                                 gpointer self)
{
    char text[200];
    char node[40];
    UMockdevIoctlBase *const handler = umockdev_ioctl_base_new();

    (void)snprintf(node, sizeof node, "/dev/%s", name);
    (void)snprintf(text, sizeof text, "P: /devices/%s\nN: %s\nE: DEVNAME=%s\nE: SUBSYSTEM=%s\n",
                   name, name, node, subsystem);
    TEST_ASSERT_TRUE(umockdev_testbed_add_from_string(spi_world_bed, text, NULL));
    (void)g_signal_connect(handler, "handle-ioctl", callback, self);
    (void)g_signal_connect(handler, "handle-write", G_CALLBACK(spi_world_kick), NULL);
    TEST_ASSERT_TRUE(umockdev_testbed_attach_ioctl(spi_world_bed, node, handler, NULL));
    g_object_unref(handler);
}

/* The path of a file of the world as others see it. */
static inline void spi_world_path(char path[200], const char *inside)
{
    char *const root = umockdev_testbed_get_root_dir(spi_world_bed);
    (void)snprintf(path, 200U, "%s%s", root, inside);
    g_free(root);
}

/* How many bytes the kernel takes in a message. */
static inline void spi_world_set_limit(const char *text)
{
    char path[200];
    const char *const folders[] = {"/sys/module", "/sys/module/spidev",
                                   "/sys/module/spidev/parameters"};
    for (unsigned i = 0U; i < 3U; i++) {
        spi_world_path(path, folders[i]);
        (void)mkdir(path, 0777);
    }
    spi_world_path(path, "/sys/module/spidev/parameters/bufsiz");
    FILE *const file = fopen(path, "w");
    (void)fputs(text, file);
    (void)fclose(file);
}

/* /dev/spidev1.0 with slots 0 to 9, /dev/spidev2.0 with those from 5 on, and the cards of `robot`.
 */
static inline void spi_world_init(const robot_t *robot)
{
    spi_world_bed = umockdev_testbed_new();
    (void)memset(&spi_world_wrong, 0, sizeof spi_world_wrong);
    (void)memset(spi_world_has, 0, sizeof spi_world_has);
    (void)memset(spi_world_kicks, 0, sizeof spi_world_kicks);
    (void)memset(spi_world_said, 0, sizeof spi_world_said);
    spi_world_devices[0] = (spi_world_device_t){.first_slot = 0U, .slot_count = 10U};
    spi_world_devices[1] = (spi_world_device_t){.first_slot = 5U, .slot_count = 5U};
    spi_world_devices[2] = spi_world_devices[1];
    (void)sem_init(&spi_world_released, 0, 0U);
    for (unsigned i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const axis = &robot->axes[i];
        sim_encoder_init(&spi_world_encoders[axis->slot], axis, 0.5, 0, 1U);
        sim_card_init(&spi_world_cards[axis->slot], axis, &spi_world_encoders[axis->slot], false,
                      0U);
        spi_world_has[axis->slot] = true;
    }
    spi_world_add("spidev1.0", "spidev", G_CALLBACK(spi_world_ioctl), &spi_world_devices[0]);
    spi_world_add("spidev2.0", "spidev", G_CALLBACK(spi_world_ioctl), &spi_world_devices[1]);
    spi_world_add("spidev1.1", "spidev", G_CALLBACK(spi_world_ioctl), &spi_world_devices[2]);
    spi_world_add("watchdog", "misc", G_CALLBACK(spi_world_watchdog), NULL);
}

static inline void spi_world_end(void)
{
    g_object_unref(spi_world_bed);
    (void)sem_destroy(&spi_world_released);
}

#endif
