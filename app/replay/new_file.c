/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/new_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

/* The one file that is written, and why the first write of it failed; 0: none has. */
static int file;
static int reason;

static int note(int failure)
{
    reason = (reason == 0) ? failure : reason;
    return -1;
}

static ssize_t take(void *cookie, const char *bytes, size_t size)
{
    size_t taken = 0U;

    (void)cookie;
    while (taken < size) {
        const ssize_t count = write(file, &bytes[taken], size - taken);
        if ((count < 0) && (errno != EINTR)) {
            (void)note(errno);
            return 0;
        }
        taken += (count > 0) ? (size_t)count : 0U;
    }
    return (ssize_t)size;
}

static int release(void *cookie)
{
    (void)cookie;
    return ((file == STDOUT_FILENO) || (close(file) == 0)) ? 0 : note(errno);
}

FILE *new_file_open(const char *path)
{
    static const cookie_io_functions_t functions = {.write = take, .close = release};

    /* A file that becomes too large is refused by a write, as a full disk is. */
    (void)signal(SIGXFSZ, SIG_IGN);
    reason = 0;
    file = (strcmp(path, "-") == 0) ? STDOUT_FILENO
                                    : open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    FILE *const opened = (file >= 0) ? fopencookie(NULL, "wb", functions) : NULL;
    if (opened == NULL) {
        (void)fprintf(stderr, "%s cannot be written (%s).\n", path, strerror(errno));
    }
    return opened;
}

bool new_file_close(FILE *opened, const char *path, bool is_made)
{
    const bool is_written = fclose(opened) == 0;
    const bool is_kept = file == STDOUT_FILENO;

    if (is_made && is_written && (reason == 0)) {
        return true;
    }
    if (!is_kept) {
        (void)remove(path);
    }
    (void)fprintf(stderr, "%s could not be written to its end (%s)%s.\n", path,
                  (reason != 0) ? strerror(reason) : "there is no room for its index",
                  is_kept ? "" : "; nothing of it is left");
    return false;
}
