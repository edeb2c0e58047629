/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/screen.h"

#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#define REPEAT_US UINT64_C(5000000)
#define DEFAULT_COLUMNS 80

bool screen_open(screen_t *self)
{
    (void)memset(self, 0, sizeof *self);
    self->is_terminal = isatty(STDOUT_FILENO) == 1;
    /* Not blocking at either end: no program ever waits for the supervisor to read. */
    return (pipe2(self->output, O_CLOEXEC | O_NONBLOCK) == 0) &&
           (pipe2(self->errors, O_CLOEXEC | O_NONBLOCK) == 0);
}

static void erase_status(screen_t *self)
{
    if (self->is_terminal && (self->status[0] != '\0')) {
        (void)fputs("\r\033[K", stdout);
    }
}

static void draw_status(const screen_t *self)
{
    if (self->is_terminal && (self->status[0] != '\0')) {
        struct winsize window = {.ws_col = DEFAULT_COLUMNS};
        (void)ioctl(STDOUT_FILENO, TIOCGWINSZ, &window);
        const int columns = (window.ws_col > 1U) ? ((int)window.ws_col - 1) : (DEFAULT_COLUMNS - 1);
        (void)printf("\r%.*s\033[K", columns, self->status);
    }
    (void)fflush(stdout);
}

void screen_say(screen_t *self, const char *format, ...)
{
    va_list arguments;

    erase_status(self);
    va_start(arguments, format);
    (void)vprintf(format, arguments);
    va_end(arguments);
    (void)putchar('\n');
    draw_status(self);
}

static void relay_errors(screen_t *self)
{
    char text[4096];
    ssize_t count = read(self->errors[0], text, sizeof text);

    if (count > 0) {
        erase_status(self);
        while (count > 0) {
            (void)fwrite(text, 1U, (size_t)count, stdout);
            count = read(self->errors[0], text, sizeof text);
        }
        draw_status(self);
    }
}

static void watch_output(screen_t *self)
{
    char text[4096];
    ssize_t count = read(self->output[0], text, sizeof text - 1U);

    while (count > 0) {
        text[count] = '\0';
        self->is_heard =
            self->is_heard || ((self->awaited != NULL) && (strstr(text, self->awaited) != NULL));
        count = read(self->output[0], text, sizeof text - 1U);
    }
}

void screen_await(screen_t *self, const char *text)
{
    self->awaited = text;
    self->is_heard = text == NULL;
}

void screen_relay(screen_t *self)
{
    watch_output(self);
    relay_errors(self);
}

void screen_show_status(screen_t *self, const char *status, uint64_t now_us)
{
    const bool is_changed = strcmp(status, self->status) != 0;

    (void)snprintf(self->status, sizeof self->status, "%s", status);
    if (self->is_terminal) {
        if (is_changed) {
            draw_status(self);
        }
    } else if ((self->shown_us == 0U) || ((now_us - self->shown_us) >= REPEAT_US)) {
        self->shown_us = now_us;
        (void)printf("%s\n", status);
        (void)fflush(stdout);
    } else {
        /* Not yet time to repeat it. */
    }
}

void screen_end_status(screen_t *self)
{
    erase_status(self);
    self->status[0] = '\0';
}
