/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_trajectory.h"

#include "http/http_act.h"
#include "http/http_reply.h"
#include "http/patience.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "trajectory/trajectory_csv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define POINTER_SIZE 24U
#define US_PER_S 1e6

/* What an upload needs; too much for a stack. */
typedef struct {
    trajectory_csv_t table;
    char text[ROUTE_SENT_MOST + 1U];
} upload_t;

static int show(http_server_t *server, const http_call_t *call, const snapshot_t *snapshot)
{
    const bool is_held = snapshot->trajectory_rows != 0U;
    const json_trajectory_t also = {
        .source = is_held ? trajectory_source_name((int32_t)snapshot->trajectory_source) : NULL,
        .time_s = (double)snapshot->trajectory_time_us / US_PER_S};
    (void)server;
    return http_reply_object(call->connection, 200, json_trajectory(snapshot, &also));
}

int http_trajectory_show(http_server_t *server, const http_call_t *call)
{
    snapshot_t snapshot;
    return exchange_read_snapshot(server->exchange, &snapshot)
               ? show(server, call, &snapshot)
               : http_reply_refuse(call->connection, PROBLEM_NO_DATA);
}

static bool names_axis(const answer_t *answer)
{
    return (answer->status == (uint32_t)STATUS_AXIS_LIMIT) ||
           (answer->status == (uint32_t)STATUS_SWITCH_ZONE) ||
           (answer->status == (uint32_t)STATUS_TRAJECTORY_SPEED) ||
           (answer->status == (uint32_t)STATUS_NEEDLE_IN);
}

/* `line`: of the table, 0: of none. */
static int refuse(http_server_t *server, const http_call_t *call, const answer_t *answer,
                  uint32_t line)
{
    const robot_t *robot = exchange_robot(server->exchange);
    char pointer[POINTER_SIZE];
    http_problem_t problem = http_problem_of_status(answer->status);
    (void)snprintf(pointer, sizeof pointer, "line %u", (unsigned)line);
    problem.pointer = (line != 0U) ? pointer : NULL;
    problem.axis = (names_axis(answer) && (answer->axis < robot->axis_count))
                       ? robot->axes[answer->axis].name
                       : NULL;
    problem.limit = http_act_limit(answer);
    return http_reply_problem(call->connection, &problem, NULL);
}

/* 0 once all were taken, otherwise the status of the refusal that was sent. `line`: of the first.
 */
static int commands(http_server_t *server, const http_call_t *call, const command_t *sent,
                    uint32_t count, uint32_t line)
{
    answer_t answers[ACT_DESK_ERRANDS];
    switch (act_desk_do_all(&server->acts, call->page, sent, count, answers)) {
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
            return refuse(server, call, &answers[i], (line != 0U) ? (line + i) : 0U);
        }
    }
    return 0;
}

static command_t command_of(uint32_t index, const trajectory_row_t *row)
{
    command_t sent = {
        .kind = (uint32_t)COMMAND_LIST_ROW, .argument = index, .value = (int32_t)row->time_ms};
    (void)memcpy(sent.ticks, row->ticks, sizeof sent.ticks);
    (void)memcpy(sent.speeds, row->speeds_ticks_per_s, sizeof sent.speeds);
    return sent;
}

static int send_rows(http_server_t *server, const http_call_t *call, const trajectory_csv_t *table)
{
    const command_t begin = {.kind = (uint32_t)COMMAND_LIST_BEGIN, .argument = table->count};
    command_t end = {.kind = (uint32_t)COMMAND_LIST_END};
    command_t sent[ACT_DESK_ERRANDS];
    int status = commands(server, call, &begin, 1U, 0U);
    uint32_t first = 0U;
    while ((first < table->count) && (status == 0)) {
        uint32_t count = 0U;
        while ((count < ACT_DESK_ERRANDS) && ((first + count) < table->count)) {
            const trajectory_row_t *row = &table->rows[first + count];
            sent[count] = command_of(first + count, row);
            end.argument = trajectory_list_crc(end.argument, row);
            count++;
        }
        status = commands(server, call, sent, count, trajectory_csv_line(first));
        first += count;
    }
    return (status == 0) ? commands(server, call, &end, 1U, 0U) : status;
}

/* Answers are there before the snapshot that shows what they say. */
static int show_held(http_server_t *server, const http_call_t *call, uint32_t rows)
{
    const uint32_t looks = patience_looks(server->exchange);
    snapshot_t snapshot;
    for (uint32_t i = 0U; i < looks; i++) {
        if (exchange_read_snapshot(server->exchange, &snapshot) &&
            (snapshot.trajectory_rows == rows)) {
            return show(server, call, &snapshot);
        }
        patience_wait();
    }
    return http_reply_refuse(call->connection, PROBLEM_NO_ANSWER);
}

static int refuse_line(const http_call_t *call, uint32_t line)
{
    char pointer[POINTER_SIZE];
    http_problem_t problem = http_problem_of(PROBLEM_BAD_BODY);
    (void)snprintf(pointer, sizeof pointer, "line %u", (unsigned)line);
    problem.pointer = pointer;
    return http_reply_problem(call->connection, &problem, NULL);
}

static int take(http_server_t *server, const http_call_t *call, upload_t *upload)
{
    const size_t size = (size_t)mg_get_request_info(call->connection)->content_length;
    const int refusal = http_call_receive(call->connection, upload->text);
    int32_t stands[ROBOT_AXIS_MAX] = {0};
    snapshot_t snapshot;
    if (refusal != 0) {
        return refusal;
    }
    if (memchr(upload->text, '\0', size) != NULL) {
        return http_reply_refuse(call->connection, PROBLEM_BAD_BODY);
    }
    upload->text[size] = '\0';
    if (!exchange_read_snapshot(server->exchange, &snapshot)) {
        return http_reply_refuse(call->connection, PROBLEM_NO_DATA);
    }
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        stands[i] = snapshot.axes[i].position_ticks;
    }
    const uint32_t line =
        trajectory_csv_read(&upload->table, upload->text, exchange_robot(server->exchange), stands);
    if (line != 0U) {
        return refuse_line(call, line);
    }
    const int status = send_rows(server, call, &upload->table);
    return (status == 0) ? show_held(server, call, upload->table.count) : status;
}

int http_trajectory_send(http_server_t *server, const http_call_t *call)
{
    upload_t *upload = malloc(sizeof *upload);
    if (upload == NULL) {
        return http_reply_refuse(call->connection, PROBLEM_NO_MEMORY);
    }
    const int status = take(server, call, upload);
    free(upload);
    return status;
}

int http_trajectory_empty(http_server_t *server, const http_call_t *call)
{
    const command_t nothing = {.kind = (uint32_t)COMMAND_LIST_BEGIN};
    const int status = commands(server, call, &nothing, 1U, 0U);
    return (status == 0) ? show_held(server, call, 0U) : status;
}

int http_trajectory_run(http_server_t *server, const http_call_t *call)
{
    const request_run_trajectory_t *body = &call->body.run_trajectory;
    const command_t run = {
        .id = body->id, .kind = (uint32_t)COMMAND_RUN_TRAJECTORY, .argument = body->checksum};
    return http_act_command(server, call, &run);
}
