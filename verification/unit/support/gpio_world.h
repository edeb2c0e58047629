/* SPDX-License-Identifier: Apache-2.0 */
/** @file Lines of GPIO chips as libgpiod shows them; a test that includes this mocks gpiod.h. */
#ifndef BORESIGHT_GPIO_WORLD_H
#define BORESIGHT_GPIO_WORLD_H

#include "mock_gpiod.h"

#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/eventfd.h>
#include <unistd.h>

#define GPIO_WORLD_CHIPS 2U
#define GPIO_WORLD_LINES 16U

/* libgpiod keeps these to itself. */
struct gpiod_line {
    bool is_taken;
    bool is_output;
    int flags;
    int value;    /* As the program sees it; -1: it cannot be read. */
    int edges;    /* Unread edges; -1: they cannot be read. */
    int stuck_at; /* Level of an output whose wire does not follow; -1: it does. */
    int file;
    unsigned sets; /* How often its value was set. */
};

struct gpiod_chip {
    bool is_open;
    struct gpiod_line lines[GPIO_WORLD_LINES];
};

static struct gpiod_chip gpio_world[GPIO_WORLD_CHIPS];
/* Place of a line that another program has; GPIO_WORLD_LINES: none. */
static unsigned gpio_world_used;

static inline struct gpiod_chip *gpio_world_open(const char *path, int calls)
{
    unsigned number = 0U;
    (void)calls;
    if ((sscanf(path, "/dev/gpiochip%u", &number) != 1) || (number >= GPIO_WORLD_CHIPS)) {
        errno = ENOENT;
        return NULL;
    }
    gpio_world[number].is_open = true;
    return &gpio_world[number];
}

static inline void gpio_world_close(struct gpiod_chip *chip, int calls)
{
    (void)calls;
    TEST_ASSERT_TRUE(chip->is_open);
    chip->is_open = false;
    for (unsigned i = 0U; i < GPIO_WORLD_LINES; i++) {
        if (chip->lines[i].file > 0) {
            (void)close(chip->lines[i].file);
        }
        chip->lines[i].file = 0;
        chip->lines[i].is_taken = false;
    }
}

static inline struct gpiod_line *gpio_world_line(struct gpiod_chip *chip, unsigned offset,
                                                 int calls)
{
    (void)calls;
    errno = EINVAL;
    return (offset < GPIO_WORLD_LINES) ? &chip->lines[offset] : NULL;
}

static inline int gpio_world_take(struct gpiod_line *line, int flags)
{
    const bool is_used = (gpio_world_used < GPIO_WORLD_LINES) &&
                         ((line == &gpio_world[0].lines[gpio_world_used]) || line->is_taken);
    errno = EBUSY;
    line->is_taken = !is_used;
    line->flags = flags;
    return is_used ? -1 : 0;
}

static inline int gpio_world_take_input(struct gpiod_line *line, const char *consumer, int flags,
                                        int calls)
{
    (void)calls;
    TEST_ASSERT_EQUAL_STRING("boresight", consumer);
    line->file = eventfd(0U, 0);
    return gpio_world_take(line, flags);
}

static inline int gpio_world_take_output(struct gpiod_line *line, const char *consumer, int flags,
                                         int value, int calls)
{
    (void)calls;
    TEST_ASSERT_EQUAL_STRING("boresight", consumer);
    line->is_output = true;
    line->value = value;
    return gpio_world_take(line, flags);
}

static inline int gpio_world_file(struct gpiod_line *line, int calls)
{
    (void)calls;
    return line->file;
}

static inline int gpio_world_get(struct gpiod_line *line, int calls)
{
    (void)calls;
    TEST_ASSERT_TRUE(line->is_taken);
    return (line->stuck_at >= 0) ? line->stuck_at : line->value;
}

static inline int gpio_world_set(struct gpiod_line *line, int value, int calls)
{
    (void)calls;
    TEST_ASSERT_TRUE(line->is_taken && line->is_output);
    line->value = value;
    line->sets++;
    return 0;
}

/* One at a time, as kernel 4.14 gives them. */
static inline int gpio_world_read(struct gpiod_line *line, struct gpiod_line_event *events,
                                  unsigned size, int calls)
{
    (void)calls;
    (void)events;
    TEST_ASSERT_TRUE(size >= 1U);
    errno = (line->edges < 0) ? EIO : EAGAIN;
    if (line->edges <= 0) {
        return -1;
    }
    line->edges--;
    return 1;
}

/* Two chips, all lines 0. */
static inline void gpio_world_init(void)
{
    (void)memset(gpio_world, 0, sizeof gpio_world);
    for (unsigned i = 0U; i < GPIO_WORLD_CHIPS * GPIO_WORLD_LINES; i++) {
        gpio_world[i / GPIO_WORLD_LINES].lines[i % GPIO_WORLD_LINES].stuck_at = -1;
    }
    gpio_world_used = GPIO_WORLD_LINES;
    gpiod_chip_open_Stub(gpio_world_open);
    gpiod_chip_close_Stub(gpio_world_close);
    gpiod_chip_get_line_Stub(gpio_world_line);
    gpiod_line_request_both_edges_events_flags_Stub(gpio_world_take_input);
    gpiod_line_request_output_flags_Stub(gpio_world_take_output);
    gpiod_line_event_get_fd_Stub(gpio_world_file);
    gpiod_line_get_value_Stub(gpio_world_get);
    gpiod_line_set_value_Stub(gpio_world_set);
    gpiod_line_event_read_multiple_Stub(gpio_world_read);
}

#endif
