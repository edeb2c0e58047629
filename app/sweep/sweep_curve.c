/* SPDX-License-Identifier: Apache-2.0 */
#include "sweep/sweep_curve.h"

#include "base/crc.h"
#include "common/utc_text.h"
#include "interface/app/names.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define FILE_MODE 0640
#define Q16 65536.0
#define BAM_PER_TURN 4294967296.0
#define S_PER_MIN 60.0
#define RUN_S ((double)LIMIT_SWEEP_RUN_MS / 1000.0)
#define COLUMNS "frequency_hz,upwards_ticks,downwards_ticks,upwards_rpm,downwards_rpm"
#define SUM "# crc32c "
#define SUM_DIGITS 8U

double sweep_curve_turns_per_min(const axis_config_t *axis, int32_t way_ticks)
{
    const double turns = (double)way_ticks * (double)axis->unit_per_tick_q16 / Q16 / BAM_PER_TURN;
    return turns * S_PER_MIN / RUN_S;
}

const axis_config_t *sweep_curve_axis(const sweep_curve_t *self, const robot_t *robot)
{
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (strcmp(robot->axes[i].name, self->axis) == 0) {
            return &robot->axes[i];
        }
    }
    return NULL;
}

/* Room is for all that there can be. */
static size_t add(char *text, size_t at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static size_t add(char *text, size_t at, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int more = vsnprintf(&text[at], SWEEP_TEXT_SIZE - at, format, arguments);
    va_end(arguments);
    return at + (size_t)more;
}

size_t sweep_curve_write(const sweep_curve_t *self, const robot_t *robot,
                         char text[SWEEP_TEXT_SIZE])
{
    const axis_config_t *axis = sweep_curve_axis(self, robot);
    char ended[UTC_TEXT_SIZE];
    size_t length = 0U;
    if (axis == NULL) {
        text[0] = '\0';
        return 0U;
    }
    utc_text_write(self->ended_us, ended);
    length = add(text, length, "# robot %s %08" PRIx32 "\n", self->robot, self->robot_crc);
    length = add(text, length, "# axis %s\n", self->axis);
    length = add(text, length, "# card high_frequency %" PRIu32 "\n", self->card_firmware);
    length = add(text, length, "# ended %s %" PRIu32 " %s\n", ended, self->end,
                 sweep_end_name((int32_t)self->end));
    length = add(text, length, COLUMNS "\n");
    for (uint32_t i = 0U; i < self->count; i++) {
        const sweep_point_t *point = &self->points[i];
        length = add(text, length, "%" PRId32 ",%" PRId32 ",%" PRId32 ",%.3f,%.3f\n", point->hertz,
                     point->up_ticks, point->down_ticks,
                     sweep_curve_turns_per_min(axis, point->up_ticks),
                     sweep_curve_turns_per_min(axis, point->down_ticks));
    }
    return add(text, length, SUM "%08" PRIx32 "\n", crc32c((const uint8_t *)text, length));
}

/* The last line has the checksum of all before it. */
static bool is_whole(const char *text)
{
    const size_t tail = (sizeof SUM - 1U) + SUM_DIGITS + 1U;
    const size_t length = strlen(text);
    char last[sizeof SUM + SUM_DIGITS + 1U];
    if (length < tail) {
        return false;
    }
    const size_t before = length - tail;
    (void)snprintf(last, sizeof last, SUM "%08" PRIx32 "\n", crc32c((const uint8_t *)text, before));
    return strcmp(&text[before], last) == 0;
}

static bool read_head(sweep_curve_t *self, const char *text, int *length)
{
    char ended[UTC_TEXT_SIZE] = "";
    const int count = sscanf(text,
                             "# robot %11s %8" SCNx32 "\n# axis %11s\n# card high_frequency "
                             "%" SCNu32 "\n# ended %24s %" SCNu32 " %*s\n" COLUMNS "\n%n",
                             self->robot, &self->robot_crc, self->axis, &self->card_firmware, ended,
                             &self->end, length);
    return (count == 6) && (*length > 0) && utc_text_read(ended, &self->ended_us);
}

sweep_kept_t sweep_curve_read(sweep_curve_t *self, const robot_t *robot, const char *text)
{
    int at = 0;
    int more = 0;
    sweep_point_t point;
    (void)memset(self, 0, sizeof *self);
    if (!is_whole(text) || !read_head(self, text, &at)) {
        return SWEEP_KEPT_DAMAGED;
    }
    while ((self->count < LIMIT_SWEEP_POINTS) &&
           (sscanf(&text[at], "%" SCNd32 ",%" SCNd32 ",%" SCNd32 ",%*f,%*f\n%n", &point.hertz,
                   &point.up_ticks, &point.down_ticks, &more) == 3)) {
        self->points[self->count] = point;
        self->count++;
        at += more;
    }
    const bool is_its = (strcmp(self->robot, robot->name) == 0) &&
                        (self->robot_crc == robot->crc) && (sweep_curve_axis(self, robot) != NULL);
    return is_its ? SWEEP_KEPT_GOOD : SWEEP_KEPT_OTHER_ROBOT;
}

static void write_path(const robot_t *robot, const char *directory, char path[SWEEP_PATH_SIZE])
{
    (void)snprintf(path, SWEEP_PATH_SIZE, "%s/sweep-%s.csv", directory, robot->name);
}

/* All of it, on the disk. */
static bool write_file(const char *path, const char *text, size_t length)
{
    const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, FILE_MODE);
    if (file < 0) {
        return false;
    }
    const bool is_written = (write(file, text, length) == (ssize_t)length) && (fsync(file) == 0);
    return (close(file) == 0) && is_written;
}

bool sweep_curve_keep(const sweep_curve_t *self, const robot_t *robot, const char *directory)
{
    char text[SWEEP_TEXT_SIZE];
    char path[SWEEP_PATH_SIZE];
    char draft[SWEEP_PATH_SIZE + 4U];
    const size_t length = sweep_curve_write(self, robot, text);
    write_path(robot, directory, path);
    (void)snprintf(draft, sizeof draft, "%s.new", path);
    return write_file(draft, text, length) && (rename(draft, path) == 0);
}

sweep_kept_t sweep_curve_find(sweep_curve_t *self, const robot_t *robot, const char *directory,
                              char text[SWEEP_TEXT_SIZE])
{
    char path[SWEEP_PATH_SIZE];
    write_path(robot, directory, path);
    text[0] = '\0';
    const int file = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) {
        return (errno == ENOENT) ? SWEEP_KEPT_NONE : SWEEP_KEPT_DAMAGED;
    }
    const ssize_t size = read(file, text, SWEEP_TEXT_SIZE - 1U);
    (void)close(file);
    text[(size > 0) ? size : 0] = '\0';
    const sweep_kept_t kept = sweep_curve_read(self, robot, text);
    if (kept != SWEEP_KEPT_GOOD) {
        text[0] = '\0';
    }
    return kept;
}
