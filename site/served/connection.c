/* SPDX-License-Identifier: Apache-2.0 */
#include "site/served/connection.h"

#include "http/gate/http_connections.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Text before `mark`, which is taken away; NULL: there is none. */
static char *take(char **rest, const char *mark)
{
    char *const first = *rest;
    char *const end = strstr(first, mark);

    if (end == NULL) {
        return NULL;
    }
    *end = '\0';
    *rest = &end[strlen(mark)];
    return first;
}

static bool read_first_line(struct mg_request_info *info, char *line)
{
    char *rest = line;

    info->request_method = take(&rest, " ");
    char *const uri = take(&rest, " HTTP/");
    info->http_version = rest;
    if ((info->request_method == NULL) || (uri == NULL)) {
        return false;
    }
    char *query = uri;
    info->request_uri = (strchr(uri, '?') != NULL) ? take(&query, "?") : uri;
    info->query_string = (query != uri) ? query : NULL;
    info->local_uri_raw = info->request_uri;
    info->local_uri = info->request_uri;
    return true;
}

static bool read_fields(struct mg_request_info *info, char *fields)
{
    char *rest = fields;
    for (char *line = take(&rest, "\r\n"); line != NULL; line = take(&rest, "\r\n")) {
        char *value = line;
        const char *const name = take(&value, ": ");
        if ((name == NULL) || (info->num_headers == MG_MAX_HEADERS)) {
            return false;
        }
        info->http_headers[info->num_headers] = (struct mg_header){.name = name, .value = value};
        info->num_headers++;
    }
    return true;
}

bool connection_read(struct mg_connection *self, char *text, size_t size, char *reported,
                     size_t room)
{
    (void)memset(self, 0, sizeof *self);
    self->reported = reported;
    self->room = room;
    self->info.content_length = -1;
    char *const end = strstr(text, "\r\n\r\n");
    if (end == NULL) {
        return false;
    }
    self->body = &end[4];
    self->body_size = size - (size_t)(self->body - text);
    end[2] = '\0';
    char *fields = text;
    char *const line = take(&fields, "\r\n");
    if (!read_first_line(&self->info, line) || !read_fields(&self->info, fields)) {
        return false;
    }
    if (mg_get_header(self, "Content-Length") != NULL) {
        self->info.content_length = (long long)self->body_size;
    }
    return true;
}

const struct mg_request_info *mg_get_request_info(const struct mg_connection *connection)
{
    return &connection->info;
}

const char *mg_get_header(const struct mg_connection *connection, const char *name)
{
    for (int i = 0; i < connection->info.num_headers; i++) {
        if (strcasecmp(connection->info.http_headers[i].name, name) == 0) {
            return connection->info.http_headers[i].value;
        }
    }
    return NULL;
}

int mg_read(struct mg_connection *connection, void *bytes, size_t size)
{
    const size_t count = (size < connection->body_size) ? size : connection->body_size;

    (void)memcpy(bytes, connection->body, count);
    connection->body = &connection->body[count];
    connection->body_size -= count;
    return (int)count;
}

/* All or nothing: a reader without room gets no part of the bytes. */
int mg_write(struct mg_connection *connection, const void *bytes, size_t size)
{
    if (size > (connection->room - connection->size)) {
        return -1;
    }
    (void)memcpy(&connection->reported[connection->size], bytes, size);
    connection->size += size;
    return (int)size;
}

struct mg_context *mg_get_context(const struct mg_connection *connection)
{
    return connection->user_data;
}

void *mg_get_user_data(const struct mg_context *context)
{
    return (void *)(uintptr_t)context;
}

void mg_set_user_connection_data(const struct mg_connection *connection, void *data)
{
    ((struct mg_connection *)(uintptr_t)connection)->own_data = data;
}

void *mg_get_user_connection_data(const struct mg_connection *connection)
{
    return connection->own_data;
}

const char *mg_get_response_code_text(const struct mg_connection *connection, int code)
{
    static const struct {
        int code;
        const char *text;
    } texts[] = {{200, "OK"},
                 {304, "Not Modified"},
                 {400, "Bad Request"},
                 {401, "Unauthorized"},
                 {403, "Forbidden"},
                 {404, "Not Found"},
                 {405, "Method Not Allowed"},
                 {409, "Conflict"},
                 {411, "Length Required"},
                 {413, "Request Entity Too Large"},
                 {415, "Unsupported Media Type"},
                 {423, "Locked"},
                 {429, "Too Many Requests"},
                 {431, "Request Header Fields Too Large"},
                 {500, "Internal Server Error"},
                 {503, "Service Unavailable"}};
    (void)connection;
    for (size_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        if (texts[i].code == code) {
            return texts[i].text;
        }
    }
    return "Unknown";
}

bool http_connections_is_leaving(const struct mg_connection *connection)
{
    (void)connection;
    return false;
}

void http_connections_note(const struct mg_connection *connection, http_line_t state)
{
    (void)connection;
    (void)state;
}
