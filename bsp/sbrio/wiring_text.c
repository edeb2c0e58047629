/* SPDX-License-Identifier: Apache-2.0 */
#include "sbrio/wiring_text.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool wiring_refuse(const wiring_reader_t *reader, const char *what, const char *why)
{
    (void)snprintf(reader->error, reader->error_size,
                   "The wiring is wrong in line %u: \"%.80s\" %s.", (unsigned)reader->line, what,
                   why);
    return false;
}

char *wiring_cut(char **rest, const char *ends)
{
    char *part = *rest;
    char *const end = part + strcspn(part, ends);

    *rest = (*end == '\0') ? NULL : (end + 1);
    *end = '\0';
    while (isspace((unsigned char)*part) != 0) {
        part++;
    }
    for (char *last = part + strlen(part);
         (last > part) && (isspace((unsigned char)last[-1]) != 0);) {
        last--;
        *last = '\0';
    }
    return part;
}

bool wiring_number(const char *text, uint32_t least, uint32_t most, uint32_t *number)
{
    char *end = NULL;

    if (isdigit((unsigned char)*text) == 0) {
        return false;
    }
    errno = 0;
    const unsigned long value = strtoul(text, &end, 10);
    *number = (uint32_t)value;
    return (errno == 0) && (*end == '\0') && (value >= least) && (value <= most);
}

bool wiring_path(const wiring_reader_t *reader, const char *text, char path[WIRING_PATH_SIZE])
{
    if (text[0] != '/') {
        return wiring_refuse(reader, text, "is no device; give its path, such as /dev/...");
    }
    if (strlen(text) >= WIRING_PATH_SIZE) {
        return wiring_refuse(reader, text, "is too long for a path");
    }
    (void)memcpy(path, text, strlen(text) + 1U);
    return true;
}

/* Number of its bytes, or more than fit; -1 for anything that is no file. */
static ssize_t read_file(int file, char text[WIRING_TEXT_SIZE])
{
    struct stat about;

    return ((fstat(file, &about) == 0) && S_ISREG(about.st_mode))
               ? read(file, text, WIRING_TEXT_SIZE)
               : -1;
}

bool wiring_load(const char *path, char text[WIRING_TEXT_SIZE], char *error, uint32_t error_size)
{
    /* Opening a pipe for reading waits for its other end. */
    const int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);

    if (file < 0) {
        (void)snprintf(
            error, error_size,
            "The wiring \"%s\" cannot be read (%s); write the file, or name another one.", path,
            strerror(errno));
        return false;
    }
    const ssize_t size = read_file(file, text);
    (void)close(file);
    if ((size < 0) || (size == (ssize_t)WIRING_TEXT_SIZE)) {
        (void)snprintf(error, error_size,
                       "The wiring \"%s\" cannot be read; it must be a text of less than %u bytes.",
                       path, WIRING_TEXT_SIZE);
        return false;
    }
    text[size] = '\0';
    return true;
}
