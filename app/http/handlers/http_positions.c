/* SPDX-License-Identifier: Apache-2.0 */
#include "http/handlers/http_positions.h"

#include "assets/chart_names.h"
#include "charts/axis_chart.h"
#include "common/clock.h"
#include "http/call/http_act.h"
#include "http/call/http_reply.h"
#include "http/view/telemetry_units.h"
#include "interface/app/handlers.h"
#include "interface/app/messages.h"
#include "limits/requirement_limits.h"

#include <stdio.h>
#include <string.h>

#define US_PER_S UINT64_C(1000000)

void http_positions_begin(http_server_t *server, const char *path)
{
    char error[256];
    saved_store_init(&server->positions);
    server->has_key = (path != NULL) && saved_key_open(&server->key, path, error, sizeof error);
    if ((path != NULL) && !server->has_key) {
        (void)fprintf(stderr, "boresight-http: %s Positions cannot be saved.\n", error);
    }
}

static cJSON *report_axes(const robot_t *robot, const position_record_t *record)
{
    static const char *const grades[] = {"fresh", "lost", "known"}; /* kept_grade_t. */
    cJSON *axes = cJSON_CreateArray();
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const kept_axis_t *axis = &record->axes[i];
        const json_saved_axis_t reported = {.name = robot->axes[i].name,
                                            .grade = grades[axis->grade],
                                            .position_ticks = axis->position_ticks,
                                            .reading_ticks = axis->reading_ticks};
        (void)cJSON_AddItemToArray(axes, json_saved_axis(&reported));
    }
    return axes;
}

static cJSON *report_file(const robot_t *robot, const position_record_t *record, const char *utc,
                          const uint8_t *seal)
{
    char sum[SAVED_SUM_SIZE];
    char hmac[SAVED_HMAC_SIZE];
    saved_write_sum(record->robot_crc, sum);
    saved_write_hmac(seal, hmac);
    const json_saved_positions_t reported = {.format = SAVED_FORMAT,
                                             .robot = robot->name,
                                             .checksum = sum,
                                             .power_on = record->power_on,
                                             .saved_utc = utc,
                                             .axes = report_axes(robot, record),
                                             .hmac = hmac};
    return json_saved_positions(&reported);
}

static int send_file(struct mg_connection *connection, const char *robot, const char *utc,
                     cJSON *object)
{
    char name[64];
    char *json = cJSON_Print(object);
    (void)snprintf(name, sizeof name, "positions-%s-%s.json", robot, utc);
    /* No name of a file on some systems. */
    for (char *colon = strchr(name, ':'); colon != NULL; colon = strchr(colon, ':')) {
        *colon = '-';
    }
    const http_reply_t reply = {.status = 200,
                                .type = HTTP_REPLY_JSON,
                                .cache = HTTP_REPLY_NO_STORE,
                                .file_name = name,
                                .body = json,
                                .size = (json != NULL) ? strlen(json) : 0U};
    const int sent = (json != NULL) ? http_reply_send(connection, &reply)
                                    : http_reply_refuse(connection, PROBLEM_NO_MEMORY);
    cJSON_free(json);
    cJSON_Delete(object);
    return sent;
}

/**
 * Answers the positions as a file.
 *
 * @satisfies SWR-STORE-024
 */
int http_positions_save(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    const robot_t *robot = exchange_robot(server->exchange);
    const uint64_t utc_us = (clock_utc_us() / US_PER_S) * US_PER_S;
    position_record_t record;
    snapshot_t snapshot;
    char utc[SAVED_UTC_SIZE];
    uint8_t seal[SAVED_SEAL_SIZE];
    if (!server->has_key) {
        return http_reply_refuse(connection, PROBLEM_NO_KEY);
    }
    if (!exchange_read_snapshot(server->exchange, &snapshot)) {
        return http_reply_refuse(connection, PROBLEM_NO_DATA);
    }
    if (!position_record_take(&record, &snapshot, utc_us)) {
        return http_reply_refuse(connection, PROBLEM_NOT_AT_REST);
    }
    if (!saved_seal_make(&server->key, &record, seal)) {
        return http_reply_refuse(connection, PROBLEM_NO_MEMORY);
    }
    saved_write_utc(utc_us, utc);
    return send_file(connection, robot->name, utc, report_file(robot, &record, utc, seal));
}

static problem_t problem_of(saved_verdict_t verdict)
{
    static const problem_t names[] = {[SAVED_OTHER_FORMAT] = PROBLEM_SAVED_OTHER_FORMAT,
                                      [SAVED_OTHER_ROBOT] = PROBLEM_SAVED_OTHER_ROBOT,
                                      [SAVED_OTHER_TABLE] = PROBLEM_SAVED_OTHER_TABLE,
                                      [SAVED_BAD_VALUE] = PROBLEM_SAVED_BAD_VALUE,
                                      [SAVED_BAD_AXES] = PROBLEM_SAVED_BAD_AXES,
                                      [SAVED_BAD_SLOTS] = PROBLEM_SAVED_BAD_SLOTS,
                                      [SAVED_ALTERED] = PROBLEM_SAVED_ALTERED,
                                      [SAVED_TOO_OLD] = PROBLEM_SAVED_TOO_OLD,
                                      [SAVED_FROM_FUTURE] = PROBLEM_SAVED_FROM_FUTURE};
    return names[verdict];
}

static cJSON *report_row(const axis_config_t *config, const snapshot_axis_t *shown,
                         const saved_row_t *row)
{
    static const char *const whys[] = {"counts_agree", "other_power_on", "unsealed",
                                       "old_list",     "miscounted",     "moved",
                                       "not_known",    "stands_there"};
    const bool is_restored = saved_plan_restores(row->why);
    const double now = telemetry_units_position(config, row->now_ticks);
    const double saved = telemetry_units_position(config, row->saved_ticks);
    const json_preview_axis_t reported = {
        .name = config->name,
        .unit = telemetry_units_name(config),
        .now = now,
        .saved = saved,
        .delta = saved - now,
        .now_ticks = row->now_ticks,
        .saved_ticks = row->saved_ticks,
        .is_restored = is_restored,
        .grade = chart_axis_reference_name(is_restored ? (uint32_t)AXIS_REFERENCE_UNVERIFIED
                                                       : shown->reference),
        .why = whys[row->why]};
    return json_preview_axis(&reported);
}

static cJSON *report_view(const saved_view_t *view, const robot_t *robot,
                          const snapshot_t *snapshot)
{
    static const char *const origins[] = {"sealed", "unsealed", "old_list"};
    char utc[SAVED_UTC_SIZE];
    cJSON *axes = cJSON_CreateArray();
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        (void)cJSON_AddItemToArray(
            axes, report_row(&robot->axes[i], &snapshot->axes[i], &view->plan.rows[i]));
    }
    saved_write_utc(view->saved.record.utc_us, utc);
    const json_positions_preview_t reported = {
        .token = view->token,
        .left_s = LIMIT_PREVIEW_S,
        .origin = origins[view->saved.origin],
        .saved_utc = (view->saved.origin != SAVED_OLD_LIST) ? utc : NULL,
        .is_same_power_on = (view->saved.origin != SAVED_OLD_LIST) &&
                            (view->saved.record.power_on == snapshot->power_on),
        .axes = axes};
    return json_positions_preview(&reported);
}

/* One of the two. */
static saved_verdict_t read_saved(saved_t *saved, const request_preview_t *body,
                                  const robot_t *robot)
{
    return body->has_file ? saved_read_file(saved, &body->file, robot)
                          : saved_read_motors(saved, body->motors, body->motors_count, robot);
}

/* The bits of the named axes; one that the robot does not have is a bit of none. */
static uint32_t find_miscounted(const request_preview_t *body, const robot_t *robot)
{
    uint32_t axes = 0U;
    for (uint32_t i = 0U; i < body->miscounted_count; i++) {
        uint32_t index = 0U;
        while ((index < robot->axis_count) &&
               (strcmp(robot->axes[index].name, body->miscounted[i]) != 0)) {
            index++;
        }
        axes |= 1U << index;
    }
    return axes;
}

static int send_view(http_server_t *server, const http_call_t *call, saved_view_t *view)
{
    const robot_t *robot = exchange_robot(server->exchange);
    snapshot_t snapshot;
    if (!exchange_read_snapshot(server->exchange, &snapshot)) {
        return http_reply_refuse(call->connection, PROBLEM_NO_DATA);
    }
    saved_plan_make(&view->plan, &view->saved, &snapshot, robot);
    if (!saved_plan_fits(&view->plan, &view->saved)) {
        return http_reply_refuse(call->connection, PROBLEM_SAVED_NOT_MOVED);
    }
    view->shown_ms = telemetry_now_ms();
    saved_store_show(&server->positions, view);
    return http_reply_object(call->connection, 200, report_view(view, robot, &snapshot));
}

/**
 * Answers what restoring positions would do, and a token for it. The token before is worth nothing
 * any more.
 *
 * @satisfies SWR-STORE-027
 */
int http_positions_preview(http_server_t *server, const http_call_t *call)
{
    const request_preview_t *body = &call->body.preview;
    saved_view_t view;
    if (body->has_file == (body->motors_count > 0U)) {
        return http_reply_refuse(call->connection, PROBLEM_SAVED_NOT_ONE);
    }
    saved_verdict_t verdict = read_saved(&view.saved, body, exchange_robot(server->exchange));
    view.saved.miscounted = find_miscounted(body, exchange_robot(server->exchange));
    if ((verdict == SAVED_GOOD) && (view.saved.origin == SAVED_SEALED) && !server->has_key) {
        return http_reply_refuse(call->connection, PROBLEM_NO_KEY);
    }
    if (verdict == SAVED_GOOD) {
        verdict = saved_judge(&view.saved, &server->key, clock_utc_us());
    }
    return (verdict == SAVED_GOOD) ? send_view(server, call, &view)
                                   : http_reply_refuse(call->connection, problem_of(verdict));
}

/* True: nothing speaks against it, and `command` has the positions. */
static bool judge(http_server_t *server, const saved_view_t *view, command_t *command,
                  problem_t *problem)
{
    const robot_t *robot = exchange_robot(server->exchange);
    snapshot_t snapshot;
    saved_plan_t now;
    *problem = PROBLEM_PREVIEW_GONE;
    if (!saved_view_is_fresh(view, telemetry_now_ms())) {
        return false;
    }
    *problem = PROBLEM_SAVED_NOTHING;
    if (view->plan.axes == 0U) {
        return false;
    }
    *problem = PROBLEM_PREVIEW_CHANGED;
    if (!exchange_read_snapshot(server->exchange, &snapshot)) {
        return false;
    }
    saved_plan_make(&now, &view->saved, &snapshot, robot);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        command->as.positions.ticks[i] = now.rows[i].next_ticks;
    }
    return saved_plan_holds(&view->plan, &now, robot);
}

/**
 * Restores what was shown, if it still is so.
 *
 * @satisfies SWR-STORE-030
 */
int http_positions_restore(http_server_t *server, const http_call_t *call)
{
    const request_restore_t *body = &call->body.restore;
    problem_t problem = PROBLEM_PREVIEW_GONE;
    saved_view_t view;
    command_t asked;
    if (!saved_store_find(&server->positions, body->token, &view)) {
        return http_reply_refuse(call->connection, problem);
    }
    command_t command = {.id = body->id,
                         .kind = (uint32_t)COMMAND_RESTORE,
                         .as.positions = {.axes = view.plan.axes, .preview = view.token}};
    /* An act that was asked for before is answered, with or without the view: the token names the
     * positions, and they are those that were sent. */
    const bool is_new = !command_client_recall(&server->acts, call->page, body->id, &asked);
    if (!is_new) {
        (void)memcpy(command.as.positions.ticks, asked.as.positions.ticks,
                     sizeof command.as.positions.ticks);
    }
    return (!is_new || judge(server, &view, &command, &problem))
               ? http_act_command(server, call, &command)
               : http_reply_refuse(call->connection, problem);
}
