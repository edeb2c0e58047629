/* SPDX-License-Identifier: Apache-2.0 */
#include "http/login/tls_front.h"

#include "http/login/text_lines.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define FILE_SIZE 4096U
#define LINE_SIZE 400U
#define KEYS 7U
#define HTTPS_PORT 443U
#define SPACE " \t\r"

static const char *const key_names[KEYS] = {"hosts",     "console",     "stop", "console-from",
                                            "stop-from", "certificate", "key"};

static char *trim(char *text)
{
    char *start = &text[strspn(text, SPACE)];

    for (size_t end = strlen(start); (end > 0U) && (strchr(SPACE, start[end - 1U]) != NULL);
         end--) {
        start[end - 1U] = '\0';
    }
    return start;
}

static bool take_hosts(tls_front_t *self, char *value)
{
    char *rest = value;

    for (char *host = strsep(&rest, ","); host != NULL; host = strsep(&rest, ",")) {
        const char *name = trim(host);
        const size_t length = strlen(name);
        const bool is_good = (length > 0U) && (length < TLS_FRONT_HOST_SIZE) &&
                             (strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789.-") == length);
        if (!is_good || (self->host_count == TLS_FRONT_HOSTS)) {
            return false;
        }
        (void)snprintf(self->hosts[self->host_count], TLS_FRONT_HOST_SIZE, "%s", name);
        self->host_count++;
    }
    return true;
}

static bool take_port(uint16_t *port, const char *value)
{
    const size_t length = strlen(value);
    const unsigned long number = strtoul(value, NULL, 10);

    *port = (uint16_t)number;
    return (length > 0U) && (length <= 5U) && (strspn(value, "0123456789") == length) &&
           (number > 0U) && (number <= UINT16_MAX);
}

/* stunnel would take the end of a line for the end of the name. */
static bool take_path(char path[TLS_FRONT_PATH_SIZE], const char *value)
{
    return (value[0] == '/') &&
           ((size_t)snprintf(path, TLS_FRONT_PATH_SIZE, "%s", value) < TLS_FRONT_PATH_SIZE);
}

static bool take_value(tls_front_t *self, size_t key, char *value)
{
    uint16_t *const ports[] = {NULL, &self->console, &self->stop, &self->console_from,
                               &self->stop_from};

    switch (key) {
    case 0U:
        return take_hosts(self, value);
    case 5U:
        return take_path(self->certificate, value);
    case 6U:
        return take_path(self->key, value);
    default:
        return take_port(ports[key], value);
    }
}

/* Fault of a line; NULL: none. */
static const char *take_line(tls_front_t *self, char *line, bool is_given[KEYS])
{
    char *equals = strchr(line, '=');

    if (equals == NULL) {
        return "expected KEY = VALUE.";
    }
    *equals = '\0';
    const char *name = trim(line);
    for (size_t key = 0U; key < KEYS; key++) {
        if (strcmp(name, key_names[key]) == 0) {
            const bool is_new = !is_given[key];
            is_given[key] = true;
            return (is_new && take_value(self, key, trim(&equals[1])))
                       ? NULL
                       : "the value cannot be read, or is given twice.";
        }
    }
    return "the key is unknown.";
}

static bool is_complete(const tls_front_t *self, const bool is_given[KEYS], const char *file,
                        char *error, size_t error_size)
{
    for (size_t key = 0U; key < KEYS; key++) {
        if (!is_given[key]) {
            (void)snprintf(error, error_size, "%s: \"%s\" is missing.", file, key_names[key]);
            return false;
        }
    }
    const uint16_t ports[] = {self->console, self->stop, self->console_from, self->stop_from};
    for (size_t i = 0U; i < 4U; i++) {
        for (size_t k = 0U; k < i; k++) {
            if (ports[i] == ports[k]) {
                (void)snprintf(error, error_size, "%s: port %u is given twice.", file,
                               (unsigned)ports[i]);
                return false;
            }
        }
    }
    return true;
}

bool tls_front_parse(tls_front_t *self, const char *file, const char *text, size_t length,
                     char *error, size_t error_size)
{
    bool is_given[KEYS] = {false};
    text_lines_t lines = {.text = text, .length = length};
    char line[LINE_SIZE];

    (void)memset(self, 0, sizeof *self);
    while (text_lines_next(&lines, line, sizeof line)) {
        char *words = trim(line);
        const bool is_reported = (words[0] != '\0') && (words[0] != '#');
        const char *fault = is_reported ? take_line(self, words, is_given) : lines.fault;
        if (fault != NULL) {
            (void)snprintf(error, error_size, "%s, line %u: %s", file, lines.number, fault);
            return false;
        }
    }
    return is_complete(self, is_given, file, error, error_size);
}

bool tls_front_read(tls_front_t *self, const char *file, char *error, size_t error_size)
{
    char text[FILE_SIZE];
    FILE *stream = fopen(file, "re");

    if (stream == NULL) {
        (void)snprintf(error, error_size, "%s cannot be read (%s).", file, strerror(errno));
        return false;
    }
    const size_t size = fread(text, 1U, sizeof text, stream);
    (void)fclose(stream);
    if (size == sizeof text) {
        (void)snprintf(error, error_size, "%s is too long.", file);
        return false;
    }
    return tls_front_parse(self, file, text, size, error, error_size);
}

bool tls_front_serves(const tls_front_t *self, uint32_t port, const char *host)
{
    for (uint32_t i = 0U; i < self->host_count; i++) {
        char expected[TLS_FRONT_HOST_SIZE + 8U];
        (void)snprintf(expected, sizeof expected, "%s:%u", self->hosts[i], (unsigned)port);
        const bool is_default = (port == HTTPS_PORT) && (strcasecmp(host, self->hosts[i]) == 0);
        if (is_default || (strcasecmp(host, expected) == 0)) {
            return true;
        }
    }
    return false;
}

void tls_front_write_stunnel(const tls_front_t *self, FILE *stream)
{
    (void)fprintf(stream,
                  "; Written by boresight-http --stunnel.\n"
                  "foreground = yes\n"
                  "pid =\n"
                  "sslVersionMin = TLSv1.2\n"
                  "socket = l:TCP_NODELAY=1\n"
                  "socket = r:TCP_NODELAY=1\n"
                  "cert = %s\n"
                  "key = %s\n"
                  "[console]\n"
                  "accept = %u\n"
                  "connect = 127.0.0.1:%u\n"
                  "TIMEOUTclose = 0\n"
                  "[stop]\n"
                  "accept = %u\n"
                  "connect = 127.0.0.1:%u\n"
                  "TIMEOUTclose = 0\n",
                  self->certificate, self->key, (unsigned)self->console,
                  (unsigned)self->console_from, (unsigned)self->stop, (unsigned)self->stop_from);
}
