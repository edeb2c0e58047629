/* SPDX-License-Identifier: Apache-2.0 */
#include "http/login/account.h"

#include "http/login/text_lines.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define LINE_SIZE 200U
#define PATH_SIZE 512U
#define FIELDS 3U
#define ROLES 4U

static const char *const role_words[ROLES] = {
    [ROLE_OBSERVER] = "observer",
    [ROLE_OPERATOR] = "operator",
    [ROLE_ENGINEER] = "engineer",
    [ROLE_SERVICE] = "service",
};

static bool refuse(char *error, size_t error_size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static bool refuse(char *error, size_t error_size, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(error, error_size, format, arguments);
    va_end(arguments);
    return false;
}

bool account_is_name(const char *text)
{
    const size_t length = strlen(text);

    return (length > 0U) && (length < ACCOUNT_NAME_SIZE) &&
           (strspn(text, "abcdefghijklmnopqrstuvwxyz0123456789-_") == length);
}

bool account_read_role(const char *text, role_t *role)
{
    for (uint32_t i = 0U; i < ROLES; i++) {
        if (strcmp(text, role_words[i]) == 0) {
            *role = (role_t)i;
            return true;
        }
    }
    return false;
}

const char *account_role_word(role_t role)
{
    return role_words[role];
}

/* Letters of a hash, as crypt(5) allows them. */
static bool is_hash(const char *text)
{
    const size_t length = strlen(text);

    return (length > 3U) && (length < ACCOUNT_HASH_SIZE) && (strncmp(text, "$y$", 3U) == 0) &&
           (strspn(text, "./$0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz") ==
            length);
}

/* Cuts a line at its colons. False when they are not two. */
static bool cut(char *line, char *fields[FIELDS])
{
    char *rest = line;

    for (size_t i = 0U; i < FIELDS; i++) {
        fields[i] = strsep(&rest, ":");
        if (fields[i] == NULL) {
            return false;
        }
    }
    return rest == NULL;
}

/* Fault of a line; NULL: none. */
static const char *take_line(accounts_t *self, char *line)
{
    char *fields[FIELDS];
    account_t account;

    if (!cut(line, fields)) {
        return "expected NAME:ROLE:HASH.";
    }
    if (!account_is_name(fields[0])) {
        return "the name must be 1 to 31 of a-z, 0-9, - and _.";
    }
    if (!account_read_role(fields[1], &account.role)) {
        return "the role must be observer, operator, engineer or service.";
    }
    if (!is_hash(fields[2])) {
        return "the hash must be one of yescrypt; make it with boresight-passwd.";
    }
    if (accounts_find(self, fields[0]) != NULL) {
        return "the name stands there a second time.";
    }
    (void)snprintf(account.name, sizeof account.name, "%s", fields[0]);
    (void)snprintf(account.hash, sizeof account.hash, "%s", fields[2]);
    return accounts_put(self, &account) ? NULL : "there are too many accounts.";
}

bool accounts_parse(accounts_t *self, const char *file, const char *text, size_t length,
                    char *error, size_t error_size)
{
    text_lines_t lines = {.text = text, .length = length};
    char line[LINE_SIZE];

    self->count = 0U;
    while (text_lines_next(&lines, line, sizeof line)) {
        const bool is_reported = (line[0] != '\0') && (line[0] != '#');
        const char *fault = is_reported ? take_line(self, line) : lines.fault;
        if (fault != NULL) {
            self->count = 0U;
            return refuse(error, error_size, "%s, line %u: %s", file, lines.number, fault);
        }
    }
    return true;
}

/* Reads all of an open file, at most `room` bytes. -1 when that fails. */
static ssize_t read_all(int descriptor, char *bytes, size_t room)
{
    size_t size = 0U;
    ssize_t count = 1;

    while ((count > 0) && (size < room)) {
        count = read(descriptor, &bytes[size], room - size);
        size += (count > 0) ? (size_t)count : 0U;
    }
    return (count < 0) ? -1 : (ssize_t)size;
}

bool accounts_read(accounts_t *self, const char *file, char *error, size_t error_size)
{
    char bytes[ACCOUNTS_FILE_SIZE + 1U];
    struct stat about;
    const int descriptor = open(file, O_RDONLY | O_CLOEXEC | O_NONBLOCK);

    self->count = 0U;
    if (descriptor < 0) {
        return refuse(error, error_size, "The accounts' file %s cannot be read (%s).", file,
                      strerror(errno));
    }
    const bool is_known = fstat(descriptor, &about) == 0;
    const ssize_t size = is_known ? read_all(descriptor, bytes, sizeof bytes) : -1;
    (void)close(descriptor);
    if ((size < 0) || !S_ISREG(about.st_mode)) {
        return refuse(error, error_size, "%s is no file that can be read.", file);
    }
    if ((about.st_mode & (mode_t)(S_IRWXG | S_IRWXO)) != 0U) {
        return refuse(error, error_size, "Others may read or change %s; chmod 600 it.", file);
    }
    if ((size_t)size > ACCOUNTS_FILE_SIZE) {
        return refuse(error, error_size, "%s is longer than %u bytes.", file,
                      (unsigned)ACCOUNTS_FILE_SIZE);
    }
    return accounts_parse(self, file, bytes, (size_t)size, error, error_size);
}

static bool write_lines(const accounts_t *self, int descriptor)
{
    bool is_good = true;

    for (uint32_t i = 0U; (i < self->count) && is_good; i++) {
        const account_t *account = &self->accounts[i];
        is_good = dprintf(descriptor, "%s:%s:%s\n", account->name, role_words[account->role],
                          account->hash) > 0;
    }
    return is_good && (fsync(descriptor) == 0);
}

/* A name in the directory is safe once the directory is. */
static void sync_directory(const char *file)
{
    char directory[PATH_SIZE];
    const char *slash = strrchr(file, '/');

    (void)snprintf(directory, sizeof directory, "%.*s",
                   (slash != NULL) ? (int)(slash - file) + 1 : 1, (slash != NULL) ? file : ".");
    const int descriptor = open(directory, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        (void)fsync(descriptor);
        (void)close(descriptor);
    }
}

bool accounts_write(const accounts_t *self, const char *file, char *error, size_t error_size)
{
    char draft[PATH_SIZE];

    if ((size_t)snprintf(draft, sizeof draft, "%s.new", file) >= sizeof draft) {
        return refuse(error, error_size, "The name of the accounts' file is too long.");
    }
    (void)unlink(draft);
    const int descriptor = open(draft, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
    bool is_good = (descriptor >= 0) && write_lines(self, descriptor);
    if (descriptor >= 0) {
        is_good = (close(descriptor) == 0) && is_good;
        is_good = is_good && (rename(draft, file) == 0);
    }
    if (!is_good) {
        (void)refuse(error, error_size, "%s cannot be written (%s).", file, strerror(errno));
        (void)unlink(draft);
        return false;
    }
    sync_directory(file);
    return true;
}

account_t *accounts_find(accounts_t *self, const char *name)
{
    for (uint32_t i = 0U; i < self->count; i++) {
        if (strcmp(self->accounts[i].name, name) == 0) {
            return &self->accounts[i];
        }
    }
    return NULL;
}

bool accounts_put(accounts_t *self, const account_t *account)
{
    account_t *place = accounts_find(self, account->name);

    if ((place == NULL) && (self->count < LIMIT_ACCOUNTS)) {
        place = &self->accounts[self->count];
        self->count++;
    }
    if (place != NULL) {
        *place = *account;
    }
    return place != NULL;
}

bool accounts_remove(accounts_t *self, const char *name)
{
    account_t *place = accounts_find(self, name);

    if (place != NULL) {
        self->count--;
        *place = self->accounts[self->count];
    }
    return place != NULL;
}
