/* SPDX-License-Identifier: Apache-2.0 */
/** @file The trajectory that is held: shown, sent as a table, emptied, run. */
#include "interface/app/handlers.h"

#include "common/list_terms.h"
#include "http/call/http_act.h"
#include "http/handlers/http_list.h"
#include "http/call/http_reply.h"
#include "http/call/http_transaction.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "trajectory/trajectory_csv.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define US_PER_S 1e6

/* Memory of an upload; too much for a stack. */
typedef struct {
    trajectory_csv_t table;
    char text[ROUTE_SENT_MOST + 1U];
} upload_t;

static int show(const http_call_t *call, const snapshot_t *snapshot)
{
    const bool is_held = snapshot->trajectory_rows != 0U;
    const json_trajectory_t also = {
        .source = is_held ? trajectory_source_name((int32_t)snapshot->trajectory_source) : NULL,
        .time_s = (double)snapshot->trajectory_time_us / US_PER_S};
    return http_reply_object(call->connection, 200, json_trajectory(snapshot, &also));
}

static uint32_t held(const snapshot_t *snapshot)
{
    return snapshot->trajectory_rows;
}

static bool item(const robot_t *robot, const void *items, uint32_t index, command_t *command,
                 uint32_t *crc)
{
    const trajectory_row_t *row = &((const trajectory_row_t *)items)[index];
    (void)robot;
    *command = list_terms_row_command(index, row);
    *crc = trajectory_list_crc(*crc, row);
    return true;
}

static void write_line(uint32_t line, char pointer[HTTP_LIST_POINTER_SIZE])
{
    (void)snprintf(pointer, HTTP_LIST_POINTER_SIZE, "line %u", (unsigned)line);
}

static void point(uint32_t index, char pointer[HTTP_LIST_POINTER_SIZE])
{
    write_line(trajectory_csv_line(index), pointer);
}

static const http_list_t trajectory = {
    COMMAND_LIST_BEGIN, COMMAND_LIST_END, show, held, item, point};

int http_trajectory_show(http_server_t *server, const http_call_t *call)
{
    return http_list_show(server, call, &trajectory);
}

static int refuse_line(const http_call_t *call, uint32_t line)
{
    char pointer[HTTP_LIST_POINTER_SIZE];
    http_problem_t problem = http_problem_of(PROBLEM_BAD_BODY);
    write_line(line, pointer);
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
    http_transaction_keep_request(call->connection, NULL, size);
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
    return http_list_send(server, call, &trajectory, upload->table.rows, upload->table.count);
}

/**
 * Sends the rows of the body, some at once and the next ones when these were taken.
 *
 * @satisfies SWR-TRAJ-015
 * @satisfies SWR-TRAJ-021
 */
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
    return http_list_empty(server, call, &trajectory);
}
