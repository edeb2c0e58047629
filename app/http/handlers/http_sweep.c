/* SPDX-License-Identifier: Apache-2.0 */
/** @file Sweeps: commanded, and the curve that is kept shown. */
#include "interface/app/handlers.h"

#include "common/axis_terms.h"
#include "common/utc_text.h"
#include "http/call/http_act.h"
#include "http/call/http_reply.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "sweep/sweep_curve.h"
#include "sweep/sweep_expected.h"

#include <string.h>

/** @satisfies SWR-SWEEP-012 */
int http_sweep_run(http_server_t *server, const http_call_t *call)
{
    const request_sweep_act_t *body = &call->body.run_sweep;
    const robot_t *robot = exchange_robot(server->exchange);
    const command_t command = {
        .id = body->id,
        .kind = (uint32_t)COMMAND_SWEEP,
        .as.sweep = {.axis = axis_terms_find(robot, body->axis),
                     .is_free = (body->has_is_free && body->is_free) ? 1U : 0U}};
    return (command.as.sweep.axis < robot->axis_count) ? http_act_command(server, call, &command)
                                                       : http_act_refuse_member(call, "/axis");
}

static cJSON *new_points(const sweep_curve_t *curve, const robot_t *robot)
{
    const axis_config_t *axis = sweep_curve_axis(curve, robot);
    cJSON *list = cJSON_CreateArray();
    for (uint32_t i = 0U; i < curve->count; i++) {
        const sweep_point_t *point = &curve->points[i];
        double expected = 0.0;
        const bool is_known = sweep_expected(axis, point->hertz, &expected);
        const json_sweep_point_t reported = {
            .frequency_hz = (uint32_t)point->hertz,
            .upwards_rpm = sweep_curve_turns_per_min(axis, point->up_ticks),
            .downwards_rpm = sweep_curve_turns_per_min(axis, point->down_ticks),
            .expected_rpm = is_known ? &expected : NULL};
        (void)cJSON_AddItemToArray(list, json_sweep_point(&reported));
    }
    return list;
}

/** @satisfies SWR-SWEEP-014 */
int http_sweep_show(http_server_t *server, const http_call_t *call)
{
    static const char *const states[] = {[SWEEP_KEPT_NONE] = "none",
                                         [SWEEP_KEPT_GOOD] = "kept",
                                         [SWEEP_KEPT_DAMAGED] = "damaged",
                                         [SWEEP_KEPT_OTHER_ROBOT] = "other_robot"};
    const robot_t *robot = exchange_robot(server->exchange);
    char text[SWEEP_TEXT_SIZE];
    char ended[UTC_TEXT_SIZE];
    sweep_curve_t curve;
    if (robot->axis_count == 0U) {
        return http_reply_refuse(call->connection, PROBLEM_NO_DATA);
    }
    const sweep_kept_t kept = sweep_curve_find(&curve, robot, server->archive.directory, text);
    const bool is_good = kept == SWEEP_KEPT_GOOD;
    utc_text_write(is_good ? curve.ended_us : 0U, ended);
    const json_sweep_t reported = {.state = states[kept],
                                   .axis = is_good ? curve.axis : NULL,
                                   .ended = is_good ? ended : NULL,
                                   .end = is_good ? sweep_end_name((int32_t)curve.end) : NULL,
                                   .points =
                                       is_good ? new_points(&curve, robot) : cJSON_CreateArray()};
    return http_reply_object(call->connection, 200, json_sweep(&reported));
}

int http_sweep_csv(http_server_t *server, const http_call_t *call)
{
    const robot_t *robot = exchange_robot(server->exchange);
    char text[SWEEP_TEXT_SIZE];
    sweep_curve_t curve;
    if (robot->axis_count == 0U) {
        return http_reply_refuse(call->connection, PROBLEM_NO_DATA);
    }
    if (sweep_curve_find(&curve, robot, server->archive.directory, text) != SWEEP_KEPT_GOOD) {
        return http_reply_refuse(call->connection, PROBLEM_NO_SWEEP_KEPT);
    }
    const http_reply_t reply = {.status = 200,
                                .type = "text/csv; charset=utf-8",
                                .cache = HTTP_REPLY_NO_STORE,
                                .file_name = "sweep.csv",
                                .body = text,
                                .size = strlen(text)};
    return http_reply_send(call->connection, &reply);
}
