/* SPDX-License-Identifier: Apache-2.0 */
#include "http/gate/http_problem.h"

#include "interface/app/names.h"
#include "interface/status.h"

#include <civetweb.h>
#include <stdio.h>
#include <string.h>

#define ESCAPE_SIZE 8U

http_problem_t http_problem_of(problem_t problem)
{
    const problem_words_t *words = &problems[problem];
    const http_problem_t reported = {
        .http = words->http, .code = words->code, .detail = words->detail};
    return reported;
}

http_problem_t http_problem_of_status(uint32_t status)
{
    switch (status) {
    case (uint32_t)STATUS_NO_AUTHORITY:
        return http_problem_of(PROBLEM_NO_AUTHORITY);
    case (uint32_t)STATUS_BUSY:
        return http_problem_of(PROBLEM_BUSY);
    case (uint32_t)STATUS_NO_ANSWER:
        return http_problem_of(PROBLEM_NO_ANSWER);
    default: {
        const http_problem_t reported = {.http = 409,
                                         .code = status_name((int32_t)status),
                                         .detail = status_text((int32_t)status)};
        return reported;
    }
    }
}

http_problem_t http_problem_of_body(const request_result_t *result)
{
    problem_t problem = PROBLEM_BAD_BODY;
    if (result->fault == REQUEST_NOT_FINITE) {
        problem = PROBLEM_NOT_FINITE;
    } else if (result->fault == REQUEST_OUT_OF_RANGE) {
        problem = PROBLEM_OUT_OF_RANGE;
    } else {
        /* It is not even of the right kind. */
    }
    http_problem_t reported = http_problem_of(problem);
    reported.detail = result->text;
    reported.pointer = result->place;
    return reported;
}

http_problem_t http_problem_of_query(const request_result_t *result)
{
    http_problem_t reported = http_problem_of(PROBLEM_BAD_QUERY);
    reported.detail = result->text;
    reported.parameter = result->place;
    return reported;
}

/* Appends as much as there is room for. */
static void add(char json[HTTP_PROBLEM_SIZE], const char *text)
{
    const size_t length = strlen(json);
    (void)snprintf(&json[length], HTTP_PROBLEM_SIZE - length, "%s", text);
}

static void add_string(char json[HTTP_PROBLEM_SIZE], const char *text)
{
    add(json, "\"");
    for (const char *byte = text; *byte != '\0'; byte++) {
        char escaped[ESCAPE_SIZE] = {*byte, '\0'};
        if ((*byte == '"') || (*byte == '\\')) {
            (void)snprintf(escaped, sizeof escaped, "\\%c", *byte);
        } else if ((unsigned char)*byte < 0x20U) {
            (void)snprintf(escaped, sizeof escaped, "\\u%04x", (unsigned)(unsigned char)*byte);
        } else {
            /* It stands for itself. */
        }
        add(json, escaped);
    }
    add(json, "\"");
}

static void add_member(char json[HTTP_PROBLEM_SIZE], const char *key, const char *text)
{
    if (text != NULL) {
        add(json, ",\"");
        add(json, key);
        add(json, "\":");
        add_string(json, text);
    }
}

const char *http_problem_title(int http)
{
    return (http == 422) ? "Unprocessable Content" : mg_get_response_code_text(NULL, http);
}

size_t http_problem_write(const http_problem_t *problem, char json[HTTP_PROBLEM_SIZE])
{
    (void)snprintf(json, HTTP_PROBLEM_SIZE, "{\"type\":\"about:blank\",\"status\":%d",
                   problem->http);
    add_member(json, "title", http_problem_title(problem->http));
    add_member(json, "detail", problem->detail);
    add_member(json, "code", problem->code);
    add_member(json, "pointer", problem->pointer);
    add_member(json, "parameter", problem->parameter);
    add_member(json, "axis", problem->axis);
    add_member(json, "limit", problem->limit);
    add(json, "}");
    return strlen(json);
}
