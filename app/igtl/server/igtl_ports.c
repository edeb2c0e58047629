/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_ports.h"

#include "igtl/server/igtl_ports_values.h"

#include <arpa/inet.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define LINE_SIZE 200U
#define LOOPBACK 127U /* 127.0.0.0/8 */

typedef enum {
    KEY_DIALECT,
    KEY_LISTEN,
    KEY_CONNECT,
    KEY_ALLOW,
    KEY_ENTRY_PREFIX,
    KEY_COUNT
} port_key_t;

static const char *const key_names[KEY_COUNT] = {"dialect", "listen", "connect", "allow",
                                                 "entry-prefix"};

typedef struct {
    igtl_ports_t *ports;
    igtl_port_t *port; /* NULL before the first section. */
    bool is_given[KEY_COUNT];
    const char *file;
    uint32_t line;
    uint32_t section_line;
    char *error;
    size_t error_size;
} reader_t;

static bool refuse(const reader_t *self, uint32_t line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static bool refuse(const reader_t *self, uint32_t line, const char *format, ...)
{
    va_list arguments;
    const int length =
        snprintf(self->error, self->error_size, "%s, line %u: ", self->file, (unsigned)line);

    if ((length > 0) && ((size_t)length < self->error_size)) {
        va_start(arguments, format);
        (void)vsnprintf(&self->error[length], self->error_size - (size_t)length, format, arguments);
        va_end(arguments);
    }
    return false;
}

bool igtl_ports_set(igtl_ports_t *self, const char *address, uint16_t brp_port, uint16_t igtl_port)
{
    static const igtl_ports_t defaults = {
        .count = 2U,
        .ports = {
            {.name = "workphases", .language = IGTL_LANGUAGE_BRP_2013, .entry_prefix = "ENTRY_"},
            {.name = "transforms", .language = IGTL_LANGUAGE_CRTK, .entry_prefix = "ENTRY_"}}};

    *self = defaults;
    self->ports[0].number = brp_port;
    self->ports[1].number = igtl_port;
    for (uint32_t i = 0U; i < self->count; i++) {
        if (!igtl_ports_read_address(address, &self->ports[i].address)) {
            return false;
        }
    }
    return true;
}

static bool take_place(const reader_t *self, port_key_t key, const char *value)
{
    self->port->is_calling = (key == KEY_CONNECT);
    if (!igtl_ports_read_place(value, &self->port->address, &self->port->number)) {
        return refuse(self, self->line, "\"%s\" is no ADDRESS:PORT, such as 192.168.1.10:18944.",
                      value);
    }
    if (self->port->is_calling && (self->port->address == 0U)) {
        return refuse(self, self->line, "0.0.0.0 cannot be called; give the peer's address.");
    }
    return true;
}

static bool take_value(const reader_t *self, port_key_t key, const char *value)
{
    switch (key) {
    case KEY_DIALECT:
        return igtl_ports_read_dialect(value, &self->port->language) ||
               refuse(self, self->line, "\"%s\" is no dialect; use brp-2013, brp-2021 or crtk.",
                      value);
    case KEY_LISTEN:
    case KEY_CONNECT:
        return take_place(self, key, value);
    case KEY_ALLOW:
        return igtl_ports_read_allowed(value, self->port) ||
               refuse(self, self->line,
                      "\"%s\" is no list of at most %u addresses or networks, such as "
                      "192.168.1.10, 192.168.7.0/24.",
                      value, (unsigned)IGTL_ALLOWED);
    case KEY_ENTRY_PREFIX:
        return igtl_ports_read_prefix(value, self->port->entry_prefix) ||
               refuse(self, self->line,
                      "\"%s\" is no prefix: 1 to 8 letters, digits, - or _, and not that of "
                      "another message.",
                      value);
    case KEY_COUNT:
    default:
        return false;
    }
}

static bool take_pair(reader_t *self, char *line)
{
    char *equals = strchr(line, '=');

    if (equals == NULL) {
        return refuse(self, self->line, "\"%s\" is neither [NAME] nor KEY = VALUE.", line);
    }
    *equals = '\0';
    const char *name = igtl_ports_trim(line);
    const char *value = igtl_ports_trim(&equals[1]);
    for (uint32_t key = 0U; key < (uint32_t)KEY_COUNT; key++) {
        if (strcmp(name, key_names[key]) != 0) {
            continue;
        }
        if (self->port == NULL) {
            return refuse(self, self->line, "\"%s\" stands before the first [NAME].", name);
        }
        if (self->is_given[key]) {
            return refuse(self, self->line, "\"%s\" is given twice.", name);
        }
        self->is_given[key] = true;
        return take_value(self, (port_key_t)key, value);
    }
    return refuse(self, self->line,
                  "\"%s\" is unknown; there are dialect, listen, connect, allow, entry-prefix.",
                  name);
}

/* They would be one place, or we would call ourselves. */
static bool is_same(const igtl_port_t *one, const igtl_port_t *other)
{
    const bool is_near =
        ((one->address >> 24U) == LOOPBACK) || ((other->address >> 24U) == LOOPBACK);
    const bool has_any = (one->address == 0U) || (other->address == 0U);

    return (one->number == other->number) &&
           ((one->address == other->address) ||
            (has_any && (is_near || (one->is_calling == other->is_calling))));
}

/* Other machines that reach the port have to be named. */
static bool has_allowed(const reader_t *self)
{
    return self->port->is_calling || self->is_given[KEY_ALLOW] ||
           ((self->port->address >> 24U) == LOOPBACK);
}

static bool end_section(const reader_t *self)
{
    const igtl_port_t *port = self->port;

    if (port == NULL) {
        return true;
    }
    if (!self->is_given[KEY_DIALECT]) {
        return refuse(self, self->section_line, "[%s] says no dialect.", port->name);
    }
    if (self->is_given[KEY_LISTEN] == self->is_given[KEY_CONNECT]) {
        return refuse(self, self->section_line, "[%s] needs either listen or connect.", port->name);
    }
    if (port->is_calling && self->is_given[KEY_ALLOW]) {
        return refuse(self, self->section_line, "[%s] connects, and needs no allow.", port->name);
    }
    if ((port->language == IGTL_LANGUAGE_CRTK) && self->is_given[KEY_ENTRY_PREFIX]) {
        return refuse(self, self->section_line, "[%s] has no use for entry-prefix.", port->name);
    }
    if (!has_allowed(self)) {
        return refuse(self, self->section_line,
                      "[%s] can be reached by other machines: say in allow by which (0.0.0.0/0 is "
                      "everyone).",
                      port->name);
    }
    for (const igtl_port_t *other = self->ports->ports; other != port; other++) {
        if (is_same(port, other)) {
            return refuse(self, self->section_line, "[%s] and [%s] have the same address.",
                          other->name, port->name);
        }
    }
    return true;
}

static bool begin_section(reader_t *self, char *line)
{
    const size_t length = strlen(line);

    if (!end_section(self)) {
        return false;
    }
    if (line[length - 1U] != ']') {
        return refuse(self, self->line, "\"%s\" lacks its ].", line);
    }
    line[length - 1U] = '\0';
    const char *name = igtl_ports_trim(&line[1]);
    if (!igtl_ports_is_word(name, IGTL_PORT_NAME_SIZE - 1U)) {
        return refuse(self, self->line, "\"%s\" is no name: 1 to %u letters, digits, - or _.", name,
                      (unsigned)(IGTL_PORT_NAME_SIZE - 1U));
    }
    if (self->ports->count == IGTL_PORTS) {
        return refuse(self, self->line, "There may be %u ports.", (unsigned)IGTL_PORTS);
    }
    for (uint32_t i = 0U; i < self->ports->count; i++) {
        if (strcmp(self->ports->ports[i].name, name) == 0) {
            return refuse(self, self->line, "[%s] is there twice.", name);
        }
    }
    self->port = &self->ports->ports[self->ports->count];
    self->ports->count++;
    *self->port = (igtl_port_t){.entry_prefix = "ENTRY_"};
    (void)snprintf(self->port->name, sizeof self->port->name, "%s", name);
    (void)memset(self->is_given, 0, sizeof self->is_given);
    self->section_line = self->line;
    return true;
}

static bool is_plain(const char *text, size_t length)
{
    bool is_all = true;

    for (size_t i = 0U; i < length; i++) {
        is_all = is_all && (((text[i] >= ' ') && (text[i] <= '~')) || (text[i] == '\t'));
    }
    return is_all;
}

static bool take_line(reader_t *self, const char *text, size_t length)
{
    char line[LINE_SIZE];

    if (length >= LINE_SIZE) {
        return refuse(self, self->line, "It is longer than %u characters.",
                      (unsigned)(LINE_SIZE - 1U));
    }
    (void)memcpy(line, text, length);
    line[length] = '\0';
    char *begin = igtl_ports_trim(line);
    if ((begin[0] == '#') || (begin[0] == '\0')) {
        return true;
    }
    if (!is_plain(text, length)) {
        return refuse(self, self->line, "It is no plain text.");
    }
    return (begin[0] == '[') ? begin_section(self, begin) : take_pair(self, begin);
}

bool igtl_ports_parse(igtl_ports_t *self, const char *file, const char *text, size_t length,
                      char *error, size_t error_size)
{
    reader_t reader = {.ports = self, .file = file, .error = error, .error_size = error_size};
    size_t at = 0U;

    (void)memset(self, 0, sizeof *self);
    while (at < length) {
        const char *end = memchr(&text[at], '\n', length - at);
        const size_t bytes = (end == NULL) ? (length - at) : (size_t)(end - &text[at]);
        const bool has_return = (bytes > 0U) && (text[at + bytes - 1U] == '\r');

        reader.line++;
        if (!take_line(&reader, &text[at], has_return ? (bytes - 1U) : bytes)) {
            return false;
        }
        at += bytes + 1U;
    }
    if (self->count == 0U) {
        return refuse(&reader, reader.line, "It names no port.");
    }
    return end_section(&reader);
}

bool igtl_ports_read(igtl_ports_t *self, const char *file, char *error, size_t error_size)
{
    char text[IGTL_PORTS_FILE + 1U];
    FILE *stream = fopen(file, "re");

    if (stream == NULL) {
        (void)snprintf(error, error_size, "The file of ports %s cannot be read: %s.", file,
                       strerror(errno));
        return false;
    }
    const size_t length = fread(text, 1U, sizeof text, stream);
    const bool is_read = ferror(stream) == 0;
    (void)fclose(stream);
    if (!is_read || (length > IGTL_PORTS_FILE)) {
        (void)snprintf(error, error_size, "The file of ports %s cannot be read: %s.", file,
                       is_read ? "it is too long" : "it is no file");
        return false;
    }
    return igtl_ports_parse(self, file, text, length, error, error_size);
}

bool igtl_port_allows(const igtl_port_t *self, uint32_t address)
{
    bool is_allowed = self->allowed_count == 0U;

    for (uint32_t i = 0U; i < self->allowed_count; i++) {
        is_allowed = is_allowed || ((address & self->allowed[i].mask) == self->allowed[i].address);
    }
    return is_allowed;
}

void igtl_port_place(uint32_t address, uint16_t number, char text[IGTL_PLACE_SIZE])
{
    const struct in_addr place = {.s_addr = htonl(address)};
    char dotted[INET_ADDRSTRLEN] = "?";

    (void)inet_ntop(AF_INET, &place, dotted, (socklen_t)sizeof dotted);
    (void)snprintf(text, IGTL_PLACE_SIZE, "%s:%u", dotted, (unsigned)number);
}
