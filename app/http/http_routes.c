/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_routes.h"

#include "http/asset.h"
#include "http/http_act.h"
#include "http/http_archive.h"
#include "http/http_authority.h"
#include "http/http_box.h"
#include "http/http_call.h"
#include "http/http_communication.h"
#include "http/http_door.h"
#include "http/http_log_note.h"
#include "http/http_modes.h"
#include "http/http_motion.h"
#include "http/http_positions.h"
#include "http/http_program.h"
#include "http/http_reply.h"
#include "http/http_sweep.h"
#include "http/http_targeting.h"
#include "http/http_transaction.h"
#include "http/http_trajectory.h"
#include "gate/stop_desk.h"
#include "gate/stop_request.h"
#include "interface/app/messages.h"
#include "request/request_headers.h"

#include <string.h>

#define FIRST_REFUSAL 400

static bool look(http_server_t *server, struct mg_connection *connection, telemetry_view_t *view)
{
    telemetry_look(&server->telemetry, view);
    if (!view->has_snapshot) {
        (void)http_reply_refuse(connection, PROBLEM_NO_DATA);
    }
    return view->has_snapshot;
}

static int answer_status(http_server_t *server, struct mg_connection *connection)
{
    telemetry_view_t view;
    return look(server, connection, &view)
               ? http_reply_object(connection, 200, telemetry_json_status(&server->identity, &view))
               : 503;
}

static int answer_robot(http_server_t *server, struct mg_connection *connection)
{
    telemetry_view_t view;
    return look(server, connection, &view)
               ? http_reply_object(connection, 200, telemetry_json_robot(&view))
               : 503;
}

static int answer_motors(http_server_t *server, struct mg_connection *connection)
{
    telemetry_view_t view;
    return look(server, connection, &view)
               ? http_reply_object(connection, 200, telemetry_json_motors(&view))
               : 503;
}

static int answer_targeting(http_server_t *server, struct mg_connection *connection)
{
    telemetry_view_t view;
    return look(server, connection, &view)
               ? http_reply_object(connection, 200, telemetry_json_targeting(&view))
               : 503;
}

/* Where the log goes on: after what the client has, or else with the last events. Numbers begin
 * anew with control; one that has not been yet is of an earlier control. */
static uint32_t first_event(const struct mg_connection *connection, uint32_t events)
{
    uint32_t last = 0U;
    const bool is_said = request_headers_number(mg_get_header(connection, "Last-Event-ID"), &last);
    if (is_said && (last < events)) {
        return last + 1U;
    }
    return (events > HTTP_STREAM_HISTORY) ? (events - HTTP_STREAM_HISTORY) : 0U;
}

static int answer_events(http_server_t *server, struct mg_connection *connection)
{
    telemetry_view_t view;
    telemetry_look(&server->telemetry, &view);
    const json_hello_t identity = {.boot_id = server->identity.boot_id,
                                   .build_id = server->identity.build_id};
    char hello[160] = "{}";
    cJSON *object = json_hello(&identity);
    (void)cJSON_PrintPreallocated(object, hello, (int)sizeof hello, 0);
    cJSON_Delete(object);
    return http_stream_serve(&server->stream, connection, hello,
                             first_event(connection, view.snapshot.events));
}

static int answer_stop(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    char json[STOP_DESK_JSON_SIZE];
    answer_t answer;
    const status_t status =
        stop_desk_converse(server->exchange, stop_request_workphase(&call->body.stop), &answer);
    const stop_report_t report = stop_desk_tell(status, &answer, json);
    return report.is_good ? http_reply_json(connection, 200, json)
                          : http_reply_problem(connection, &report.problem, NULL);
}

static int answer_asset(struct mg_connection *connection, const asset_t *asset)
{
    const bool is_packed = (asset->packed_size > 0U) &&
                           request_headers_take_gzip(mg_get_header(connection, "Accept-Encoding"));
    char etag[ASSET_ETAG_SIZE];
    asset_write_etag(asset, is_packed, etag);
    const bool is_known = request_headers_know(mg_get_header(connection, "If-None-Match"), etag);
    const http_reply_t reply = {.status = is_known ? 304 : 200,
                                .type = is_known ? NULL : asset->type,
                                .cache = asset->cache,
                                .etag = etag,
                                .encoding = (is_packed && !is_known) ? "gzip" : NULL,
                                .is_chosen = asset->packed_size > 0U,
                                .body = is_packed ? asset->packed : asset->bytes,
                                .size = is_packed ? asset->packed_size : asset->size};
    return http_reply_send(connection, &reply);
}

/* A route that is described is answered here: without its case this does not compile. */
static int answer(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    switch (call->route->id) {
    case ROUTE_STATUS:
        return answer_status(server, connection);
    case ROUTE_ROBOT:
        return answer_robot(server, connection);
    case ROUTE_MOTORS:
        return answer_motors(server, connection);
    case ROUTE_TARGETING:
        return answer_targeting(server, connection);
    case ROUTE_LOG:
        return http_archive_log(server, call);
    case ROUTE_LOG_CSV:
        return http_archive_log_csv(server, call);
    case ROUTE_LOG_LEVEL:
        return http_archive_log_level(server, call);
    case ROUTE_SET_LOG_LEVEL:
        return http_archive_set_log_level(server, call);
    case ROUTE_LOGS:
        return http_archive_logs(server, call);
    case ROUTE_LOG_FILE:
        return http_archive_log_file(server, call);
    case ROUTE_RECORDINGS:
        return http_archive_recordings(server, call);
    case ROUTE_RECORDING:
        return http_archive_recording(server, call);
    case ROUTE_LOG_NOTE:
        return http_log_note_write(server, call);
    case ROUTE_EVENTS:
        return answer_events(server, connection);
    case ROUTE_STOP:
        return answer_stop(server, call);
    case ROUTE_OPENAPI:
        return answer_asset(connection, asset_find(call->route->path));
    case ROUTE_SESSION:
    case ROUTE_RENEW:
        return http_door_show(server, connection);
    case ROUTE_LOGIN:
        return http_door_log_in(server, call);
    case ROUTE_LOGOUT:
        return http_door_log_out(server, connection);
    case ROUTE_AUTHORITY:
        return http_authority_show(server, call);
    case ROUTE_TAKE:
        return http_authority_take(server, call);
    case ROUTE_RENEW_AUTHORITY:
        return http_authority_renew(server, call);
    case ROUTE_RELEASE:
        return http_authority_release(server, call);
    case ROUTE_REQUEST:
        return http_authority_request(server, call);
    case ROUTE_WORKPHASE:
        return http_motion_workphase(server, call);
    case ROUTE_JOG:
        return http_motion_jog(server, call);
    case ROUTE_HOME_AXIS:
        return http_motion_axis(server, call, COMMAND_HOME_AXIS, call->body.home_axis.id);
    case ROUTE_CLEAR_AXIS:
        return http_motion_axis(server, call, COMMAND_CLEAR_AXIS, call->body.clear_axis.id);
    case ROUTE_CONFIRM_AXIS:
        return http_motion_axis(server, call, COMMAND_CONFIRM_AXIS, call->body.confirm_axis.id);
    case ROUTE_SET_HOME:
        return http_motion_axis(server, call, COMMAND_SET_HOME, call->body.set_home.id);
    case ROUTE_VELOCITY:
        return http_motion_velocity(server, call);
    case ROUTE_RUN_SWEEP:
        return http_sweep_run(server, call);
    case ROUTE_SWEEP:
        return http_sweep_show(server, call);
    case ROUTE_SWEEP_CSV:
        return http_sweep_csv(server, call);
    case ROUTE_ENABLE_AXIS:
        return http_motion_axis(server, call, COMMAND_ENABLE_AXIS, call->body.enable_axis.id);
    case ROUTE_DISABLE_AXIS:
        return http_motion_axis(server, call, COMMAND_DISABLE_AXIS, call->body.disable_axis.id);
    case ROUTE_ACCEPT_NO_BLACK_BOX:
        return http_motion_bare(server, call, COMMAND_ACCEPT_NO_BLACK_BOX,
                                call->body.accept_no_black_box.id);
    case ROUTE_REGISTRATION:
        return http_targeting_register(server, call);
    case ROUTE_PROBE:
        return http_targeting_set_probe(server, call);
    case ROUTE_ENTRY:
        return http_targeting_enter(server, call);
    case ROUTE_TARGET:
        return http_targeting_aim(server, call);
    case ROUTE_WITHDRAW:
        return http_targeting_withdraw(server, call);
    case ROUTE_PREVIEW_TARGET:
        return http_targeting_preview(server, call);
    case ROUTE_RETRACT:
        return http_motion_bare(server, call, COMMAND_RETRACT, call->body.retract.id);
    case ROUTE_ALIGN:
        return http_motion_bare(server, call, COMMAND_ALIGN, call->body.align.id);
    case ROUTE_INSERT:
        return http_motion_bare(server, call, COMMAND_INSERT, call->body.insert.id);
    case ROUTE_POSE:
        return http_motion_pose(server, call);
    case ROUTE_POSITIONS:
        return http_positions_save(server, connection);
    case ROUTE_PREVIEW:
        return http_positions_preview(server, call);
    case ROUTE_RESTORE:
        return http_positions_restore(server, call);
    case ROUTE_MODES:
        return http_modes_show(server, call);
    case ROUTE_TRAJECTORY:
        return http_trajectory_show(server, call);
    case ROUTE_SEND_TRAJECTORY:
        return http_trajectory_send(server, call);
    case ROUTE_EMPTY_TRAJECTORY:
        return http_trajectory_empty(server, call);
    case ROUTE_RUN_TRAJECTORY:
        return http_trajectory_run(server, call);
    case ROUTE_PROGRAM:
        return http_program_show(server, call);
    case ROUTE_SEND_PROGRAM:
        return http_program_send(server, call);
    case ROUTE_EMPTY_PROGRAM:
        return http_program_empty(server, call);
    case ROUTE_RUN_PROGRAM:
        return http_program_run(server, call);
    case ROUTE_COMMUNICATION:
        return http_communication_show(server, call);
    case ROUTE_DISCONNECT:
        return http_communication_disconnect(server, call);
    case ROUTE_KEEP_ALIVE:
        return http_communication_keep_alive(server, call);
    case ROUTE_BOX:
        return http_box_show(server, call);
    case ROUTE_ORDER_BOX:
        return http_box_order(server, call);
    case ROUTE_KEEP_BOX:
        return http_box_keep(server, call);
    case ROUTE_DROP_BOX:
        return http_box_drop(server, call);
    default:
        return http_reply_refuse(connection, PROBLEM_NOT_FOUND);
    }
}

static int refuse_method(struct mg_connection *connection, const char *allowed)
{
    const http_problem_t problem = http_problem_of(PROBLEM_METHOD_NOT_ALLOWED);
    return http_reply_problem(connection, &problem, allowed);
}

/* What is no route may be a file of the console. */
static int answer_other(struct mg_connection *connection, const char *allowed)
{
    const struct mg_request_info *request = mg_get_request_info(connection);
    const asset_t *asset =
        (request->local_uri_raw != NULL) ? asset_find(request->local_uri_raw) : NULL;
    if (allowed != NULL) {
        return refuse_method(connection, allowed);
    }
    if (asset == NULL) {
        return http_reply_refuse(connection, PROBLEM_NOT_FOUND);
    }
    const bool is_got =
        (strcmp(request->request_method, "GET") == 0) || http_reply_is_head_asked(connection);
    if (!is_got) {
        return refuse_method(connection, "GET, HEAD");
    }
    return (request->content_length > 0) ? http_reply_refuse(connection, PROBLEM_BODY_TOO_LONG)
                                         : answer_asset(connection, asset);
}

static int dispatch(http_server_t *server, http_call_t *call, const char *allowed)
{
    struct mg_connection *connection = call->connection;
    int status = http_call_judge(
        connection, http_door_is_tls(server, connection) ? &server->front_guard : &server->guard);
    if (status != 0) {
        return status;
    }
    if (call->route == NULL) {
        return answer_other(connection, allowed);
    }
    status = http_door_judge(server, call);
    if (status == 0) {
        status = http_act_judge(server, call);
    }
    if (status == 0) {
        status = http_call_read(call, exchange_robot(server->exchange));
    }
    return (status != 0) ? status : answer(server, call);
}

/* A page that is not logged in, or asks for what is not there, asks again and again. */
static bool is_idle(bool is_read, int status)
{
    const bool is_of_reads = (status == 401) || (status == 404) || (status == 503);
    return (is_read && is_of_reads) || (status == 429);
}

static bool is_noted(const http_call_t *call, int status)
{
    const char *method = mg_get_request_info(call->connection)->request_method;
    const bool is_read = (strcmp(method, "GET") == 0) || http_reply_is_head_asked(call->connection);
    const route_noted_t noted = (call->route != NULL) ? call->route->noted : ROUTE_NOTED_REFUSED;
    const bool is_refused = (status >= FIRST_REFUSAL) && !is_idle(is_read, status);
    return (noted == ROUTE_NOTED_ALWAYS) || ((noted == ROUTE_NOTED_REFUSED) && is_refused);
}

static void note(http_server_t *server, const http_call_t *call, int status,
                 const http_transaction_t *transaction)
{
    const struct mg_request_info *request = mg_get_request_info(call->connection);
    session_t session;
    const bool has_session = http_door_find(server, call->connection, &session);
    const http_record_entry_t entry = {
        .who = has_session ? session.account.name : NULL,
        .method = request->request_method,
        .path = (request->local_uri_raw != NULL) ? request->local_uri_raw : "",
        .request = transaction->request,
        .status = status,
        .answer = transaction->answer};
    http_record_write(&server->record, &entry, telemetry_now_ms());
}

int http_routes_answer(http_server_t *server, struct mg_connection *connection)
{
    const char *allowed = NULL;
    http_transaction_t transaction;
    http_call_t call = {.connection = connection};
    http_transaction_begin(&transaction, connection);
    call.route = http_call_find(connection, &allowed);
    const int sent = dispatch(server, &call, allowed);
    const int status = (sent != 0) ? sent : 499;
    http_transaction_end(connection);
    if (is_noted(&call, status)) {
        note(server, &call, status, &transaction);
    }
    return status;
}
