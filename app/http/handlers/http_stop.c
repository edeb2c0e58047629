/* SPDX-License-Identifier: Apache-2.0 */
/** @file The stop, as a route of the console's port; stop_port.h has a port of its own for it. */
#include "interface/app/handlers.h"

#include "http/stop/stop_command.h"
#include "http/stop/stop_request.h"
#include "http/call/http_reply.h"

int http_stop_command(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    char json[STOP_COMMAND_JSON_SIZE];
    answer_t answer;
    const status_t status = stop_command_send_and_wait(
        server->exchange, stop_request_workphase(&call->body.stop), &answer);
    const stop_report_t report = stop_command_report(status, &answer, json);
    return report.is_good ? http_reply_json(connection, 200, json)
                          : http_reply_problem(connection, &report.problem, NULL);
}
