/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/screen.h"

#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#define DEFAULT_COLUMNS 80U

/* As https://no-color.org asks for. */
static bool wants_colours(void)
{
    const char *const refused = getenv("NO_COLOR");
    const char *const terminal = getenv("TERM");

    return ((refused == NULL) || (refused[0] == '\0')) && (terminal != NULL) &&
           (strcmp(terminal, "dumb") != 0);
}

bool screen_open(screen_t *self)
{
    (void)memset(self, 0, sizeof *self);
    self->is_terminal = isatty(STDOUT_FILENO) == 1;
    self->is_coloured = self->is_terminal && wants_colours();
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
        (void)printf("\r%s\033[K", self->status);
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

/* Without the last one, where some terminals begin a new line. */
static uint32_t columns(void)
{
    struct winsize window = {.ws_col = 0U};

    (void)ioctl(STDOUT_FILENO, TIOCGWINSZ, &window);
    return ((window.ws_col > 1U) ? window.ws_col : DEFAULT_COLUMNS) - 1U;
}

void screen_show_status(screen_t *self, const status_parts_t *status, uint64_t now_us)
{
    char line[SCREEN_LINE_SIZE];

    status_parts_write(status, self->is_terminal ? columns() : 0U, self->is_coloured, line,
                       sizeof line);
    if (self->is_terminal) {
        if (strcmp(line, self->status) != 0) {
            (void)snprintf(self->status, sizeof self->status, "%s", line);
            draw_status(self);
        }
    } else if (status_repeat_is_due(&self->repeat, status, now_us)) {
        (void)printf("%s\n", line);
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
