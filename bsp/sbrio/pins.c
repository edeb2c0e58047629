/* SPDX-License-Identifier: Apache-2.0 */
#include "sbrio/pins.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>

#define CONSUMER "boresight"
/* So many edges of a line the kernel keeps. */
#define KEPT_EDGES 16U
#define EVERY_INPUT ((1U << WIRING_INPUTS) - 1U)

static int flags_of(const wiring_t *wiring, const wiring_line_t *line)
{
    const int pull = line->is_active_low ? GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP
                                         : GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN;

    return (line->is_active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0) |
           (wiring->are_pulled[line->chip] ? pull : 0);
}

/* Reading edges must never wait. */
static bool request_input(struct gpiod_line *line, int flags)
{
    if (gpiod_line_request_both_edges_events_flags(line, CONSUMER, flags) != 0) {
        return false;
    }
    const int file = gpiod_line_event_get_fd(line);
    return (file >= 0) && (fcntl(file, F_SETFL, O_NONBLOCK) == 0);
}

static bool open_line(pins_t *self, const wiring_t *wiring, uint32_t place)
{
    const wiring_line_t *const wired = &wiring->lines[place];
    struct gpiod_line *const line = gpiod_chip_get_line(self->chips[wired->chip], wired->offset);

    self->lines[place] = line;
    if (line == NULL) {
        return false;
    }
    if (place < (uint32_t)WIRING_INPUTS) {
        return request_input(line, flags_of(wiring, wired));
    }
    return gpiod_line_request_output_flags(
               line, CONSUMER, wired->is_active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0, 0) ==
           0;
}

static bool open_chips(pins_t *self, const wiring_t *wiring, char *error, uint32_t error_size)
{
    for (uint32_t i = 0U; i < wiring->chip_count; i++) {
        self->chips[i] = gpiod_chip_open(wiring->chips[i]);
        if (self->chips[i] == NULL) {
            (void)snprintf(error, error_size,
                           "The GPIO chip %s cannot be opened (%s); check the device tree and the "
                           "rights of this user.",
                           wiring->chips[i], strerror(errno));
            return false;
        }
    }
    return true;
}

static bool open_lines(pins_t *self, const wiring_t *wiring, char *error, uint32_t error_size)
{
    for (uint32_t i = 0U; i < (uint32_t)WIRING_LINES; i++) {
        const wiring_line_t *const wired = &wiring->lines[i];
        if (wired->is_there && !open_line(self, wiring, i)) {
            (void)snprintf(error, error_size,
                           "Line %u of %s cannot be taken (%s); end who uses it, or give another "
                           "one%s.",
                           (unsigned)wired->offset, wiring->chips[wired->chip], strerror(errno),
                           wiring->are_pulled[wired->chip] ? "; a kernel before 5.5 has no \"pull\""
                                                           : "");
            return false;
        }
    }
    return true;
}

bool pins_open(pins_t *self, const wiring_t *wiring, char *error, uint32_t error_size)
{
    (void)memset(self, 0, sizeof *self);
    if (!open_chips(self, wiring, error, error_size) ||
        !open_lines(self, wiring, error, error_size)) {
        pins_close(self);
        return false;
    }
    return true;
}

/* @return number of edges since this was asked last; -1: unknown */
static int take_edges(struct gpiod_line *line)
{
    struct gpiod_line_event edges[KEPT_EDGES];
    int count = 0;

    for (;;) {
        const int more = gpiod_line_event_read_multiple(line, edges, KEPT_EDGES);
        if (more <= 0) {
            return ((more == 0) || (errno == EAGAIN)) ? count : -1;
        }
        count += more;
        if (count >= (int)KEPT_EDGES) {
            return count;
        }
    }
}

pins_sample_t pins_sample(pins_t *self)
{
    pins_sample_t sample = {0U, 0U, 0U};
    bool has_overflowed = false;

    for (uint32_t i = 0U; i < (uint32_t)WIRING_INPUTS; i++) {
        const uint32_t bit = 1U << i;
        if (self->lines[i] == NULL) {
            continue;
        }
        const int level = gpiod_line_get_value(self->lines[i]);
        const int edges = take_edges(self->lines[i]);
        if ((level >= 0) && (edges >= 0)) {
            sample.valid |= bit;
            sample.levels |= (level == 1) ? bit : 0U;
        }
        sample.dropped |= ((level != 1) || (edges != 0)) ? bit : 0U;
        has_overflowed = has_overflowed || (edges >= (int)KEPT_EDGES);
    }
    sample.dropped |= has_overflowed ? EVERY_INPUT : 0U;
    return sample;
}

bool pins_set_power(const pins_t *self, bool is_on)
{
    struct gpiod_line *const line = self->lines[WIRING_POWER];
    const int value = is_on ? 1 : 0;

    return (gpiod_line_set_value(line, value) == 0) && (gpiod_line_get_value(line) == value);
}

void pins_set_lamps(pins_t *self, uint32_t lamps)
{
    const uint32_t changed = lamps ^ self->lamps;

    for (uint32_t i = 0U; i < (uint32_t)(WIRING_LINES - WIRING_LAMPS); i++) {
        struct gpiod_line *const line = self->lines[(uint32_t)WIRING_LAMPS + i];
        if ((line != NULL) && ((changed & (1U << i)) != 0U)) {
            (void)gpiod_line_set_value(line, ((lamps & (1U << i)) != 0U) ? 1 : 0);
        }
    }
    self->lamps = lamps;
}

void pins_close(pins_t *self)
{
    for (uint32_t i = 0U; i < WIRING_CHIPS; i++) {
        if (self->chips[i] != NULL) {
            gpiod_chip_close(self->chips[i]);
        }
    }
    (void)memset(self, 0, sizeof *self);
}
