/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes by which a page sees authority, keeps it and gives it up. */
#include "interface/app/handlers.h"

#include "http/call/http_act.h"
#include "http/call/http_reply.h"
#include "http/gate/answer_timeout.h"

int http_authority_show(http_server_t *server, const http_call_t *call)
{
    telemetry_view_t view;
    telemetry_look(&server->telemetry, &view);
    return view.has_snapshot
               ? http_reply_object(call->connection, 200, telemetry_json_authority(&view))
               : http_reply_refuse(call->connection, PROBLEM_NO_DATA);
}

int http_authority_renew(http_server_t *server, const http_call_t *call)
{
    const command_t command = {.kind = (uint32_t)COMMAND_RENEW};
    return command_client_send(&server->acts, call->page, &command)
               ? http_authority_show(server, call)
               : http_reply_refuse(call->connection, PROBLEM_BUSY);
}

/* Waits until the authority or the request of `page` is seen no more, or control is too late. */
static void await_release(const http_server_t *server, uint32_t page)
{
    const uint32_t looks = answer_timeout_looks(server->exchange);
    snapshot_t snapshot;
    for (uint32_t i = 0U; i < looks; i++) {
        const bool is_there = exchange_read_snapshot(server->exchange, &snapshot) &&
                              (((snapshot.holder == (uint32_t)COMMAND_SOURCE_HTTP) &&
                                (snapshot.holder_peer == page)) ||
                               ((snapshot.requester == (uint32_t)COMMAND_SOURCE_HTTP) &&
                                (snapshot.requester_peer == page)));
        if (!is_there) {
            return;
        }
        answer_timeout_wait();
    }
}

int http_authority_release(http_server_t *server, const http_call_t *call)
{
    const command_t command = {.kind = (uint32_t)COMMAND_RELEASE};
    if (!command_client_send(&server->acts, call->page, &command)) {
        return http_reply_refuse(call->connection, PROBLEM_BUSY);
    }
    await_release(server, call->page);
    return http_authority_show(server, call);
}
