/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A control box for the unchanged programs of the board sbrio, as a library that is loaded before
 * all others: it answers spidev's system calls, on whatever file, with the simulated cards of the
 * NeuroRobot, at rest, and has the lines of libgpiod. Inputs are 0, the safe state.
 */
#include "base/contract.h"
#include "card/card_frame.h"
#include "robot/robot_neuro.h"
#include "sim/model/sim_card.h"
#include "sim/model/sim_encoder.h"

#include <gpiod.h>
#include <linux/spi/spidev.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

/* Seen by the program; all else here is hidden from it. */
#define INSTEAD __attribute__((visibility("default")))

#define LINES 16U

/* libgpiod keeps these to itself. */
struct gpiod_line {
    int value;
    int file;
};

struct gpiod_chip {
    struct gpiod_line lines[LINES];
};

static struct gpiod_chip chip;
static sim_card_t cards[CARD_SLOT_COUNT];
static sim_encoder_t encoders[CARD_SLOT_COUNT];
static uint8_t mode;
static uint8_t bits;
static uint32_t clock_hz;

__attribute__((constructor)) static void switch_on(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const axis = &robot_neuro.axes[i];
        sim_encoder_init(&encoders[axis->slot], axis, 0.5, 0, 1U);
        sim_card_init(&cards[axis->slot], axis, &encoders[axis->slot], false, 0U);
    }
}

/* Contract of the code that the cards are made of. */
void contract_broken(const char *module, uint32_t id)
{
    (void)module;
    (void)id;
    abort();
}

/* The frame says itself which slot the multiplexer has come to. */
static void exchange(const struct spi_ioc_transfer *transfer)
{
    const uint8_t *const sent = (const uint8_t *)(uintptr_t)transfer->tx_buf;
    uint8_t *const received = (uint8_t *)(uintptr_t)transfer->rx_buf;
    card_command_t command;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const uint32_t slot = robot_neuro.axes[i].slot;
        if (card_frame_decode_command(sent, slot, &command) == CARD_FRAME_OK) {
            sim_card_report(&cards[slot], &encoders[slot], received);
            sim_card_receive(&cards[slot], sent);
        }
    }
}

static int transfer_all(unsigned long request, const struct spi_ioc_transfer *transfers)
{
    const unsigned long count = _IOC_SIZE(request) / sizeof *transfers;
    for (unsigned long i = 0U; i < count; i++) {
        exchange(&transfers[i]);
    }
    return (int)(count * CARD_FRAME_BYTES);
}

static int keep(void *kept, const void *given, size_t size)
{
    (void)memcpy(kept, given, size);
    return 0;
}

INSTEAD int ioctl(int file, unsigned long request, ...)
{
    va_list arguments;
    va_start(arguments, request);
    void *const argument = va_arg(arguments, void *);
    va_end(arguments);
    switch (request) {
    case SPI_IOC_WR_MODE:
        return keep(&mode, argument, sizeof mode);
    case SPI_IOC_RD_MODE:
        return keep(argument, &mode, sizeof mode);
    case SPI_IOC_WR_BITS_PER_WORD:
        return keep(&bits, argument, sizeof bits);
    case SPI_IOC_RD_BITS_PER_WORD:
        return keep(argument, &bits, sizeof bits);
    case SPI_IOC_WR_MAX_SPEED_HZ:
        return keep(&clock_hz, argument, sizeof clock_hz);
    case SPI_IOC_RD_MAX_SPEED_HZ:
        return keep(argument, &clock_hz, sizeof clock_hz);
    default:
        return (_IOC_TYPE(request) == SPI_IOC_MAGIC)
                   ? transfer_all(request, argument)
                   : (int)syscall(SYS_ioctl, file, request, argument);
    }
}

INSTEAD struct gpiod_chip *gpiod_chip_open(const char *path)
{
    (void)path;
    return &chip;
}

INSTEAD void gpiod_chip_close(struct gpiod_chip *self)
{
    for (uint32_t i = 0U; i < LINES; i++) {
        if (self->lines[i].file > 0) {
            (void)close(self->lines[i].file);
        }
    }
    (void)memset(self, 0, sizeof *self);
}

INSTEAD struct gpiod_line *gpiod_chip_get_line(struct gpiod_chip *self, unsigned offset)
{
    return (offset < LINES) ? &self->lines[offset] : NULL;
}

INSTEAD int gpiod_line_request_both_edges_events_flags(struct gpiod_line *line,
                                                       const char *consumer, int flags)
{
    (void)consumer;
    (void)flags;
    line->file = eventfd(0U, EFD_CLOEXEC);
    return (line->file < 0) ? -1 : 0;
}

INSTEAD int gpiod_line_request_output_flags(struct gpiod_line *line, const char *consumer,
                                            int flags, int value)
{
    (void)consumer;
    (void)flags;
    line->value = value;
    return 0;
}

INSTEAD int gpiod_line_event_get_fd(struct gpiod_line *line)
{
    return line->file;
}

INSTEAD int gpiod_line_event_read_multiple(struct gpiod_line *line, struct gpiod_line_event *events,
                                           unsigned count)
{
    (void)line;
    (void)events;
    (void)count;
    return 0;
}

INSTEAD int gpiod_line_get_value(struct gpiod_line *line)
{
    return line->value;
}

INSTEAD int gpiod_line_set_value(struct gpiod_line *line, int value)
{
    line->value = value;
    return 0;
}
