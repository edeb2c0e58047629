/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/export/new_file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The one file that is written, and why the first write of it failed; 0: none has. */
static int file;
static int reason;
static bool is_named;

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

/* Without a name until it is whole, so that nothing stays of it when the program is killed; under
 * its name where the file system has none without. */
static int create(const char *path)
{
    const char *const name = strrchr(path, '/');
    char folder[PATH_MAX] = ".";
    struct stat status;

    if (lstat(path, &status) == 0) {
        errno = EEXIST;
        return -1;
    }
    if (name != NULL) {
        (void)snprintf(folder, sizeof folder, "%.*s", (int)(name - path) + 1, path);
    }
    const int created = open(folder, O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    is_named = (created < 0) && (errno == EOPNOTSUPP);
    return is_named ? open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666) : created;
}

/* A whole file gets its name, unless another file has it by now. */
static void give_name(const char *path)
{
    char link[32];

    (void)snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    is_named = linkat(AT_FDCWD, link, AT_FDCWD, path, AT_SYMLINK_FOLLOW) == 0;
    if (!is_named) {
        (void)note(errno);
    }
}

FILE *new_file_open(const char *path)
{
    static const cookie_io_functions_t functions = {.write = take, .close = release};

    /* A file that becomes too large is refused by a write, as a full disk is. */
    (void)signal(SIGXFSZ, SIG_IGN);
    reason = 0;
    file = (strcmp(path, "-") == 0) ? STDOUT_FILENO : create(path);
    FILE *const opened = (file >= 0) ? fopencookie(NULL, "wb", functions) : NULL;
    if (opened == NULL) {
        (void)fprintf(stderr, "%s cannot be written (%s).\n", path, strerror(errno));
    }
    return opened;
}

bool new_file_close(FILE *opened, const char *path, bool is_made)
{
    const bool is_kept = file == STDOUT_FILENO;
    bool is_whole = is_made && (fflush(opened) == 0) && (reason == 0);

    if (is_whole && !is_kept && !is_named) {
        give_name(path);
    }
    is_whole = (fclose(opened) == 0) && is_whole && (reason == 0);
    if (is_whole) {
        return true;
    }
    if (!is_kept && is_named) {
        (void)remove(path);
    }
    (void)fprintf(stderr, "%s could not be written to its end (%s)%s.\n", path,
                  (reason != 0) ? strerror(reason) : "there is no room for its index",
                  is_kept ? "" : "; nothing of it is left");
    return false;
}
