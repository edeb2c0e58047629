/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/new_file.h"

#include <errno.h>
#include <string.h>

FILE *new_file_open(const char *path)
{
    FILE *const file = (strcmp(path, "-") == 0) ? stdout : fopen(path, "wbx");

    if (file == NULL) {
        (void)fprintf(stderr, "%s cannot be written (%s).\n", path, strerror(errno));
    }
    return file;
}

bool new_file_close(FILE *file, const char *path, bool is_written)
{
    const bool is_closed = (file == stdout) || (fclose(file) == 0);

    if (!is_written || !is_closed) {
        (void)fprintf(stderr, "%s could not be written to its end.\n", path);
    }
    return is_written && is_closed;
}
