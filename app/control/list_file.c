/* SPDX-License-Identifier: Apache-2.0 */
#include "control/list_file.h"

#include "interface/app/names.h"
#include "trajectory/trajectory_csv.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Too much for a stack. */
typedef struct {
    trajectory_csv_t table;
    char text[LIMIT_TRAJECTORY_FILE_BYTES + 2U];
} list_file_t;

static bool read_text(list_file_t *self, const char *path, char *error, uint32_t error_size)
{
    FILE *file = fopen(path, "r");
    const size_t size = (file != NULL) ? fread(self->text, 1U, sizeof self->text - 1U, file) : 0U;

    if ((file == NULL) || (ferror(file) != 0)) {
        (void)snprintf(error, error_size, "the trajectory %s cannot be read (%s)", path,
                       strerror(errno));
    } else if ((size > LIMIT_TRAJECTORY_FILE_BYTES) || (memchr(self->text, '\0', size) != NULL)) {
        (void)snprintf(error, error_size, "the trajectory %s is no text of at most %u bytes", path,
                       LIMIT_TRAJECTORY_FILE_BYTES);
    } else {
        error[0] = '\0';
    }
    if (file != NULL) {
        (void)fclose(file);
    }
    self->text[size] = '\0';
    return error[0] == '\0';
}

static bool take(list_file_t *self, controller_t *controller, const robot_t *robot,
                 const char *path, char *error, uint32_t error_size)
{
    uint32_t row = 0U;

    if (!read_text(self, path, error, error_size)) {
        return false;
    }
    const uint32_t line = trajectory_csv_read(&self->table, self->text, robot, NULL);
    if (line != 0U) {
        (void)snprintf(error, error_size,
                       "the trajectory %s, line %u: cannot be read; the first line names time and "
                       "every axis with their units, each other one has a number of each",
                       path, (unsigned)line);
        return false;
    }
    const solution_t judged =
        controller_hold(controller, robot, self->table.rows, self->table.count, &row);
    if (judged.status != STATUS_OK) {
        (void)snprintf(error, error_size, "the trajectory %s, line %u, %s: %s: %s", path,
                       (unsigned)trajectory_csv_line(row), robot->axes[judged.axis].name,
                       status_name((int32_t)judged.status), status_text((int32_t)judged.status));
        return false;
    }
    return true;
}

bool list_file_take(controller_t *controller, const robot_t *robot, const char *path, char *error,
                    uint32_t error_size)
{
    list_file_t *self = malloc(sizeof *self);

    if (self == NULL) {
        (void)snprintf(error, error_size, "there is no memory for the trajectory %s", path);
        return false;
    }
    const bool is_taken = take(self, controller, robot, path, error, error_size);
    free(self);
    return is_taken;
}
