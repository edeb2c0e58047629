/* SPDX-License-Identifier: Apache-2.0 */
#include "http/call/http_reply.h"

#include "http/call/http_transaction.h"

#include <stdio.h>
#include <string.h>

static bool write_all(struct mg_connection *connection, const void *bytes, size_t size)
{
    return (size == 0U) || (mg_write(connection, bytes, size) == (int)size);
}

bool http_reply_is_head_asked(const struct mg_connection *connection)
{
    const char *method = mg_get_request_info(connection)->request_method;
    return (method != NULL) && (strcmp(method, "HEAD") == 0);
}

int http_reply_send(struct mg_connection *connection, const http_reply_t *reply)
{
    char head[HTTP_REPLY_HEAD_SIZE];
    if (!write_all(connection, head, http_head_write(reply, head))) {
        return 0;
    }
    const bool is_whole = !http_head_has_body(reply) || reply->is_apart ||
                          http_reply_is_head_asked(connection) ||
                          write_all(connection, reply->body, reply->size);
    return is_whole ? reply->status : 0;
}

int http_reply_json(struct mg_connection *connection, int status, const char *json)
{
    http_reply_t reply = {.status = status,
                          .type = HTTP_REPLY_JSON,
                          .cache = HTTP_REPLY_NO_STORE,
                          .body = json,
                          .size = strlen(json)};
    http_transaction_keep_answer(connection, json, reply.size);
    return http_reply_send(connection, &reply);
}

int http_reply_object(struct mg_connection *connection, int status, cJSON *object)
{
    char *json = cJSON_PrintUnformatted(object);
    const int sent = (json != NULL) ? http_reply_json(connection, status, json)
                                    : http_reply_refuse(connection, PROBLEM_NO_MEMORY);
    cJSON_free(json);
    cJSON_Delete(object);
    return sent;
}

int http_reply_problem(struct mg_connection *connection, const http_problem_t *problem,
                       const char *allow)
{
    char json[HTTP_PROBLEM_SIZE];
    const http_reply_t reply = {.status = problem->http,
                                .type = HTTP_REPLY_PROBLEM,
                                .cache = HTTP_REPLY_NO_STORE,
                                .allow = allow,
                                .retry_after_s = problem->retry_after_s,
                                .body = json,
                                .size = http_problem_write(problem, json)};
    http_transaction_keep_answer(connection, json, reply.size);
    return http_reply_send(connection, &reply);
}

int http_reply_refuse(struct mg_connection *connection, problem_t problem)
{
    const http_problem_t reported = http_problem_of(problem);
    return http_reply_problem(connection, &reported, NULL);
}
