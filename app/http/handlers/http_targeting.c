/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes of probe, registration, entry point and target. Each returns the status sent.
 */
#include "interface/app/handlers.h"

#include "http/call/http_act.h"
#include "http/call/http_reply.h"
#include "http/view/json_forms.h"
#include "http/view/preview.h"
#include "http/view/telemetry_units.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define NUMBERS 16U
#define POINTER_SIZE 32U
#define UM_PER_MM 1000.0
#define NM_PER_MM 1000000.0

/* The aim; NULL: not given. */
typedef struct {
    const double *matrix;
    const request_quaternion_pose_t *pose;
    const double *point_mm;
} aim_t;

/* A matrix by rows. Returns 0 with `pose`, or the status of the refusal that was sent. */
static int read_pose(const http_call_t *call, const double numbers[NUMBERS], rigid_t *pose)
{
    char pointer[POINTER_SIZE];
    const uint32_t wrong = telemetry_units_pose(numbers, pose);
    (void)snprintf(pointer, sizeof pointer, "/matrix/%u", (unsigned)wrong);
    return (wrong == NUMBERS)
               ? 0
               : http_act_refuse_range(call, pointer, telemetry_units_pose_range(wrong));
}

/** @satisfies SWR-HTTP-031 */
int http_targeting_register(http_server_t *server, const http_call_t *call)
{
    const request_registration_t *body = &call->body.registration;
    const bool is_ignored = body->has_ignore_rotation && (body->ignore_rotation != 0U);
    command_t command = {.id = body->id,
                         .kind = (uint32_t)COMMAND_REGISTRATION,
                         .as.registration = {.use = (uint32_t)(is_ignored ? REGISTRATION_TRANSLATION
                                                                          : REGISTRATION_WHOLE)}};
    const int refusal = read_pose(call, body->matrix, &command.as.registration.pose);
    return (refusal != 0) ? refusal : http_act_command(server, call, &command);
}

/* Its place in the robot's probe; beyond all places if the robot has no length of this name. */
static uint32_t place_of(const robot_t *robot, const char *name)
{
    uint32_t place = 0U;
    while ((place < robot->probe_length_count) && (strcmp(robot->probe_names[place], name) != 0)) {
        place++;
    }
    return place;
}

/* The member of `length` at fault; NULL if none is. `taken`: the places that were named before. */
static const char *take_length(const robot_t *robot, const request_named_length_t *length,
                               uint32_t *taken, command_t *command)
{
    const uint32_t place = place_of(robot, length->name);
    const int32_t length_nm = (int32_t)lround(length->length_mm * NM_PER_MM);
    if ((place >= robot->probe_length_count) || (((*taken >> place) & 1U) != 0U)) {
        return "name";
    }
    *taken |= (uint32_t)1U << place;
    command->as.probe.lengths_nm[place] = length_nm;
    return ((length_nm < robot->probe_minimum.length_nm[place]) ||
            (length_nm > robot->probe_maximum.length_nm[place]))
               ? "length_mm"
               : NULL;
}

/* Which length is wrong is known here; whether it may be changed now, control knows. */
/**
 * Lengths count by their names.
 *
 * @satisfies SWR-PROBE-008
 * @satisfies SWR-PROBE-010
 */
int http_targeting_set_probe(http_server_t *server, const http_call_t *call)
{
    const robot_t *robot = exchange_robot(server->exchange);
    const request_probe_t *body = &call->body.probe;
    char pointer[POINTER_SIZE];
    uint32_t taken = 0U;
    command_t command = {.id = body->id,
                         .kind = (uint32_t)COMMAND_PROBE,
                         .as.probe = {.count = body->lengths_count}};
    for (uint32_t i = 0U; i < body->lengths_count; i++) {
        const char *member = take_length(robot, &body->lengths[i], &taken, &command);
        if (member != NULL) {
            (void)snprintf(pointer, sizeof pointer, "/lengths/%u/%s", (unsigned)i, member);
            return http_act_refuse_member(call, pointer);
        }
    }
    return http_act_command(server, call, &command);
}

/** @satisfies SWR-PUNCT-618 */
int http_targeting_expect(http_server_t *server, const http_call_t *call)
{
    const request_membranes_t *body = &call->body.membranes;
    command_t command = {.id = body->id,
                         .kind = (uint32_t)COMMAND_MEMBRANES,
                         .as.membranes = {.count = body->depths_mm_count}};
    for (uint32_t i = 0U; i < body->depths_mm_count; i++) {
        command.as.membranes.depths_um[i] = (int32_t)lround(body->depths_mm[i] * UM_PER_MM);
    }
    return http_act_command(server, call, &command);
}

/** @satisfies SWR-HTTP-031 */
int http_targeting_enter(http_server_t *server, const http_call_t *call)
{
    const request_entry_t *body = &call->body.entry;
    command_t command = {.id = body->id, .kind = (uint32_t)COMMAND_ENTRY};
    rigid_set_identity(&command.as.pose.pose);
    telemetry_units_read_point(body->point_mm, &command.as.pose.pose.translation);
    return http_act_command(server, call, &command);
}

/* As control would answer it. */
static answer_t refusal_of(const solution_t *solution)
{
    answer_t answer = {.command = (uint32_t)COMMAND_TARGET};
    answer_refuse(&answer, (uint32_t)solution->status, solution->axis, solution->is_maximum);
    return answer;
}

static int refuse_aim(http_server_t *server, const http_call_t *call, const solution_t *solution)
{
    const answer_t answer = refusal_of(solution);
    return (solution->status == STATUS_NOT_PROPOSED)
               ? http_reply_refuse(call->connection, PROBLEM_NO_ENTRY)
               : http_act_refuse(server, call, &answer);
}

/* Returns as read_pose(). */
static int read_quaternion(const http_call_t *call, const request_quaternion_pose_t *body,
                           rigid_t *pose)
{
    const double quaternion[4] = {body->w, body->x, body->y, body->z};
    return telemetry_units_quaternion(body->point_mm, quaternion, pose)
               ? 0
               : http_reply_refuse(call->connection, PROBLEM_NO_UNIT_QUATERNION);
}

/* Target from a matrix or a pose, or a point with the entry point. Returns as read_pose(). */
static int read_target(http_server_t *server, const http_call_t *call, const aim_t *aim,
                       const snapshot_t *snapshot, rigid_t *pose)
{
    const uint32_t said = ((aim->matrix != NULL) ? 1U : 0U) + ((aim->pose != NULL) ? 1U : 0U) +
                          ((aim->point_mm != NULL) ? 1U : 0U);
    point_t target;
    if (said != 1U) {
        return http_act_refuse_choice(call, said > 1U, "/matrix");
    }
    if (aim->pose != NULL) {
        return read_quaternion(call, aim->pose, pose);
    }
    if (aim->matrix != NULL) {
        return read_pose(call, aim->matrix, pose);
    }
    telemetry_units_read_point(aim->point_mm, &target);
    const solution_t solution =
        preview_aim(exchange_robot(server->exchange), snapshot, &target, pose);
    return (solution.status == STATUS_OK) ? 0 : refuse_aim(server, call, &solution);
}

/** @satisfies SWR-HTTP-031 */
int http_targeting_aim(http_server_t *server, const http_call_t *call)
{
    const request_target_t *body = &call->body.target;
    command_t command = {.id = body->id, .kind = (uint32_t)COMMAND_TARGET};
    const aim_t aim = {.matrix = (body->matrix_count > 0U) ? body->matrix : NULL,
                       .pose = body->has_pose ? &body->pose : NULL,
                       .point_mm = (body->point_mm_count > 0U) ? body->point_mm : NULL};
    snapshot_t snapshot;
    if (!exchange_read_snapshot(server->exchange, &snapshot)) {
        return http_reply_refuse(call->connection, PROBLEM_NO_DATA);
    }
    const int refusal = read_target(server, call, &aim, &snapshot, &command.as.pose.pose);
    return (refusal != 0) ? refusal : http_act_command(server, call, &command);
}

static cJSON *new_axes(const robot_t *robot, const preview_t *preview)
{
    cJSON *axes = cJSON_CreateArray();
    const bool is_good = preview->solution.status == STATUS_OK;
    for (uint32_t i = 0U; is_good && (i < robot->axis_count); i++) {
        const axis_config_t *axis = &robot->axes[i];
        const int32_t room = preview_room_ticks(axis, preview->ticks[i]);
        const json_target_axis_t row = {.name = axis->name,
                                        .unit = telemetry_units_name(axis),
                                        .position =
                                            telemetry_units_position(axis, preview->ticks[i]),
                                        .margin = telemetry_units_position(axis, room)};
        (void)cJSON_AddItemToArray(axes, json_target_axis(&row));
    }
    return axes;
}

static cJSON *new_preview(const robot_t *robot, const preview_t *preview)
{
    const solution_t *solution = &preview->solution;
    const bool is_good = solution->status == STATUS_OK;
    const answer_t answer = refusal_of(solution);
    const json_target_preview_t reported = {
        .is_reachable = is_good,
        .code = status_name((int32_t)solution->status),
        .message = status_text((int32_t)solution->status),
        .axis = is_good ? NULL : http_act_axis(robot, &answer),
        .limit = http_act_limit(&answer),
        .tightest = is_good ? robot->axes[preview->tightest].name : NULL,
        .reached = is_good ? json_new_matrix(&preview->reached) : NULL,
        .axes = new_axes(robot, preview)};
    return json_target_preview(&reported);
}

int http_targeting_preview(http_server_t *server, const http_call_t *call)
{
    const robot_t *robot = exchange_robot(server->exchange);
    const request_aim_t *body = &call->body.preview_target;
    const aim_t aim = {.matrix = (body->matrix_count > 0U) ? body->matrix : NULL,
                       .pose = body->has_pose ? &body->pose : NULL,
                       .point_mm = (body->point_mm_count > 0U) ? body->point_mm : NULL};
    snapshot_t snapshot;
    rigid_t pose;
    if (!exchange_read_snapshot(server->exchange, &snapshot)) {
        return http_reply_refuse(call->connection, PROBLEM_NO_DATA);
    }
    const int refusal = read_target(server, call, &aim, &snapshot, &pose);
    if (refusal != 0) {
        return refusal;
    }
    const preview_t preview = preview_target(robot, &snapshot, &pose);
    return http_reply_object(call->connection, 200, new_preview(robot, &preview));
}
