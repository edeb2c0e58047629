/* SPDX-License-Identifier: Apache-2.0 */
#include "http/stop/stop_request.h"

#include "limits/requirement_limits.h"
#include "request/request_body.h"
#include "request/request_headers.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define BODY_MOST 256U

/* The headers that count, and others that would decide elsewhere. */
typedef enum {
    FIELD_HOST = 0,
    FIELD_ORIGIN = 1,
    FIELD_FETCH_SITE = 2,
    FIELD_LENGTH = 3,
    FIELD_TRANSFER = 4,
    FIELD_EXPECT = 5,
    FIELD_COUNT = 10
} field_t;

static const char *const field_names[FIELD_COUNT] = {
    "Host",   "Origin",       "Sec-Fetch-Site", "Content-Length",    "Transfer-Encoding",
    "Expect", "Content-Type", "Cookie",         "X-Boresight-Token", "X-Boresight-Page"};

static stop_request_t refuse(problem_t problem)
{
    const stop_request_t refusal = {.is_whole = true, .is_refused = true, .problem = problem};
    return refusal;
}

workphase_t stop_request_workphase(const request_stop_t *body)
{
    return (body->has_emergency && body->emergency) ? WORKPHASE_EMERGENCY : WORKPHASE_STOP;
}

static stop_request_t judge_line(const char *line)
{
    const stop_request_t good = {.is_whole = true};
    const char *path = strchr(line, ' ');
    const char *version = (path != NULL) ? strchr(path + 1, ' ') : NULL;
    if ((version == NULL) || (strncmp(version, " HTTP/1.", 8U) != 0) || (strlen(version) != 9U)) {
        return refuse(PROBLEM_BAD_REQUEST);
    }
    if (strncmp(path, " /api/v1/stop HTTP", 18U) != 0) {
        return refuse(PROBLEM_NOT_FOUND);
    }
    if (strncmp(line, "POST ", 5U) != 0) {
        return refuse(PROBLEM_METHOD_NOT_ALLOWED);
    }
    return good;
}

/* Notes a header that counts. False when it cannot be read, or comes a second time; an expectation
 * that comes again means the same (RFC 9110, 10.1.1). */
static bool take_field(char *line, const char *fields[FIELD_COUNT])
{
    char *colon = strchr(line, ':');
    if ((colon == NULL) || (strcspn(line, " \t") < (size_t)(colon - line))) {
        return false;
    }
    *colon = '\0';
    char *value = colon + 1 + strspn(colon + 1, " \t");
    for (size_t end = strlen(value); (end > 0U) && (strchr(" \t", value[end - 1U]) != NULL);
         end--) {
        value[end - 1U] = '\0';
    }
    for (size_t i = 0U; i < FIELD_COUNT; i++) {
        if (strcasecmp(line, field_names[i]) == 0) {
            const bool is_good = (fields[i] == NULL) || (i == (size_t)FIELD_EXPECT);
            fields[i] = value;
            return is_good;
        }
    }
    return true;
}

/* Cuts the head into lines. False when one of them is no header, or they are too many. */
static bool take_fields(char *line, const char *fields[FIELD_COUNT])
{
    for (uint32_t count = 1U; *line != '\0'; count++) {
        char *end = strstr(line, "\r\n");
        *end = '\0';
        if (!take_field(line, fields) || (count > LIMIT_HEAD_FIELDS)) {
            return false;
        }
        line = end + 2;
    }
    return true;
}

static stop_request_t judge_provenance(const http_guard_t *guard,
                                       const char *const fields[FIELD_COUNT])
{
    const http_provenance_t provenance = {.host = fields[FIELD_HOST],
                                          .origin = fields[FIELD_ORIGIN],
                                          .fetch_site = fields[FIELD_FETCH_SITE]};
    stop_request_t good = {.is_whole = true};
    switch (http_guard_judge(guard, &provenance)) {
    case HTTP_GUARD_PASS:
        (void)snprintf(good.origin, sizeof good.origin, "%s",
                       (provenance.origin != NULL) ? provenance.origin : "");
        return good;
    case HTTP_GUARD_NO_HOST:
        return refuse(PROBLEM_HOST_MISSING);
    case HTTP_GUARD_HOST:
        return refuse(PROBLEM_HOST_REFUSED);
    case HTTP_GUARD_ORIGIN:
    case HTTP_GUARD_CROSS_SITE:
    default:
        return refuse(PROBLEM_ORIGIN_REFUSED);
    }
}

/* Bytes behind the announced ones belong to no stop. */
static stop_request_t judge_body(const char *const fields[FIELD_COUNT], const char *body,
                                 size_t size)
{
    stop_request_t good = {.is_whole = true, .workphase = WORKPHASE_STOP};
    request_stop_t read = {.has_emergency = false};
    const char *length = fields[FIELD_LENGTH];
    if ((length == NULL) || (fields[FIELD_TRANSFER] != NULL) || (length[0] == '\0') ||
        (strspn(length, "0123456789") != strlen(length))) {
        return refuse(PROBLEM_LENGTH_REQUIRED);
    }
    if ((strlen(length) > 3U) || (strtoul(length, NULL, 10) > BODY_MOST)) {
        return refuse(PROBLEM_BODY_TOO_LONG);
    }
    const size_t announced = (size_t)strtoul(length, NULL, 10);
    if (size < announced) {
        const stop_request_t more_needed = {.is_held = size == 0U};
        return more_needed;
    }
    if ((announced == 0U) || ((announced == 2U) && (memcmp(body, "{}", 2U) == 0))) {
        return good;
    }
    stop_request_t other = refuse(PROBLEM_BAD_BODY);
    other.body = request_read_body(&request_stop, body, announced, &read);
    good.workphase = stop_request_workphase(&read);
    return (other.body.fault == REQUEST_OK) ? good : other;
}

/* Cuts `head` into its lines. */
static stop_request_t judge_head(const http_guard_t *guard, char *head,
                                 const char *fields[FIELD_COUNT])
{
    char *line_end = strstr(head, "\r\n");
    *line_end = '\0';
    const stop_request_t line = judge_line(head);
    if (line.is_refused) {
        return line;
    }
    if (!take_fields(line_end + 2, fields)) {
        return refuse(PROBLEM_BAD_REQUEST);
    }
    stop_request_t judged = judge_provenance(guard, fields);
    judged.is_held = request_headers_expect(line_end - strlen("1.1"), fields[FIELD_EXPECT]);
    return judged;
}

stop_request_t stop_request_read(const http_guard_t *guard, char *bytes, size_t size)
{
    const char *fields[FIELD_COUNT] = {NULL};
    char head[STOP_REQUEST_SIZE + 1U];
    const stop_request_t more_needed = {.is_whole = false};
    bytes[size] = '\0';
    const char *head_end = strstr(bytes, "\r\n\r\n");
    if ((head_end == NULL) && (memchr(bytes, '\0', size) != NULL)) {
        return refuse(PROBLEM_BAD_REQUEST);
    }
    if (head_end == NULL) {
        return (size < STOP_REQUEST_SIZE) ? more_needed : refuse(PROBLEM_TOO_MANY_HEADERS);
    }
    (void)snprintf(head, sizeof head, "%.*s", (int)(head_end + 2 - bytes), bytes);
    stop_request_t request = judge_head(guard, head, fields);
    if (request.is_refused) {
        return request;
    }
    const char *body = head_end + 4;
    stop_request_t whole = judge_body(fields, body, size - (size_t)(body - bytes));
    whole.is_held = whole.is_held && request.is_held;
    request.workphase = whole.workphase;
    return (whole.is_whole && !whole.is_refused) ? request : whole;
}
