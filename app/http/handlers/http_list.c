/* SPDX-License-Identifier: Apache-2.0 */
#include "http/handlers/http_list.h"

#include "http/call/http_act.h"
#include "http/call/http_reply.h"
#include "http/gate/answer_timeout.h"

#define NO_ITEM UINT32_MAX

int http_list_show(http_server_t *server, const http_call_t *call, const http_list_t *list)
{
    snapshot_t snapshot;
    return exchange_read_snapshot(server->exchange, &snapshot)
               ? list->show(call, &snapshot)
               : http_reply_refuse(call->connection, PROBLEM_NO_DATA);
}

static int refuse(http_server_t *server, const http_call_t *call, const http_list_t *list,
                  const answer_t *answer, uint32_t index)
{
    char pointer[HTTP_LIST_POINTER_SIZE];
    http_problem_t problem = http_problem_of_status(answer->status);
    if (index != NO_ITEM) {
        list->point(index, pointer);
        problem.pointer = pointer;
    }
    problem.axis = http_act_axis(exchange_robot(server->exchange), answer);
    problem.limit = http_act_limit(answer);
    return http_reply_problem(call->connection, &problem, NULL);
}

/* 0 once all were taken, otherwise the status of the refusal that was sent. `first`: item of the
 * first. */
static int commands(http_server_t *server, const http_call_t *call, const http_list_t *list,
                    const command_t *sent, uint32_t count, uint32_t first)
{
    answer_t answers[COMMAND_CLIENT_BATCH];
    switch (command_client_do_all(&server->acts, call->page, sent, count, answers)) {
    case ACT_ANSWERED:
        break;
    case ACT_LATER:
        return http_reply_refuse(call->connection, PROBLEM_BUSY);
    case ACT_ID_USED:
    case ACT_NO_ANSWER:
    default:
        return http_reply_refuse(call->connection, PROBLEM_NO_ANSWER);
    }
    for (uint32_t i = 0U; i < count; i++) {
        if (answers[i].kind == (uint32_t)ANSWER_REFUSED) {
            return refuse(server, call, list, &answers[i],
                          (first == NO_ITEM) ? NO_ITEM : (first + i));
        }
    }
    return 0;
}

static int refuse_item(const http_call_t *call, const http_list_t *list, uint32_t index)
{
    char pointer[HTTP_LIST_POINTER_SIZE];
    list->point(index, pointer);
    return http_act_refuse_member(call, pointer);
}

static int send_items(http_server_t *server, const http_call_t *call, const http_list_t *list,
                      const void *items, uint32_t total, uint32_t *crc)
{
    const robot_t *robot = exchange_robot(server->exchange);
    command_t sent[COMMAND_CLIENT_BATCH];
    int status = 0;
    for (uint32_t first = 0U; (first < total) && (status == 0); first += COMMAND_CLIENT_BATCH) {
        uint32_t count = 0U;
        while ((count < COMMAND_CLIENT_BATCH) && ((first + count) < total)) {
            if (!list->item(robot, items, first + count, &sent[count], crc)) {
                return refuse_item(call, list, first + count);
            }
            count++;
        }
        status = commands(server, call, list, sent, count, first);
    }
    return status;
}

/* Answers are there before the snapshot that shows what they say. */
static int show_held(http_server_t *server, const http_call_t *call, const http_list_t *list,
                     uint32_t count)
{
    const uint32_t looks = answer_timeout_looks(server->exchange);
    snapshot_t snapshot;
    for (uint32_t i = 0U; i < looks; i++) {
        if (exchange_read_snapshot(server->exchange, &snapshot) &&
            (list->held(&snapshot) == count)) {
            return list->show(call, &snapshot);
        }
        answer_timeout_wait();
    }
    return http_reply_refuse(call->connection, PROBLEM_NO_ANSWER);
}

int http_list_send(http_server_t *server, const http_call_t *call, const http_list_t *list,
                   const void *items, uint32_t count)
{
    const command_t begin = {.kind = (uint32_t)list->begin, .as.list_begin = {.count = count}};
    command_t end = {.kind = (uint32_t)list->end};
    int status = commands(server, call, list, &begin, 1U, NO_ITEM);
    if (status == 0) {
        status = send_items(server, call, list, items, count, &end.as.list.checksum);
    }
    if (status == 0) {
        status = commands(server, call, list, &end, 1U, NO_ITEM);
    }
    return (status == 0) ? show_held(server, call, list, count) : status;
}

int http_list_empty(http_server_t *server, const http_call_t *call, const http_list_t *list)
{
    const command_t nothing = {.kind = (uint32_t)list->begin};
    const int status = commands(server, call, list, &nothing, 1U, NO_ITEM);
    return (status == 0) ? show_held(server, call, list, 0U) : status;
}
