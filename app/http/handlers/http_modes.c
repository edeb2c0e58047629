/* SPDX-License-Identifier: Apache-2.0 */
/** @file The route that shows what motions there are, and which may be commanded now. */
#include "interface/app/handlers.h"

#include "exchange/exchange_rows.h"
#include "http/view/axis_availability.h"
#include "http/view/command_availability.h"
#include "http/call/http_login_gate.h"
#include "http/call/http_reply.h"
#include "http/view/mode_availability.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "mode/mode.h"

static cJSON *new_workphases(uint32_t workphases)
{
    cJSON *list = cJSON_CreateArray();
    for (uint32_t i = 0U; i < WORKPHASE_COUNT; i++) {
        if (((workphases >> i) & 1U) != 0U) {
            (void)cJSON_AddItemToArray(list, cJSON_CreateString(workphase_name((int32_t)i)));
        }
    }
    return list;
}

static const char *name_of(status_t status)
{
    return (status == STATUS_OK) ? NULL : status_name((int32_t)status);
}

/* NULL: nothing stands against it. For a wrong workphase, the right one of `kind`. */
static const char *reason_of(status_t status, uint32_t kind)
{
    const char *where = command_kind_where((int32_t)kind);
    const bool is_elsewhere = (status == STATUS_WRONG_WORKPHASE) && (where[0] != '\0');
    const char *reason = is_elsewhere ? where : status_text((int32_t)status);
    return (status == STATUS_OK) ? NULL : reason;
}

static cJSON *new_axes(const telemetry_view_t *view, mode_kind_t kind)
{
    const bool is_for_axes = mode_rows[kind].axes == (uint32_t)MODE_AXES_COMMANDED;
    const uint32_t count = is_for_axes ? view->robot->axis_count : 0U;
    cJSON *axes = cJSON_CreateArray();
    for (uint32_t i = 0U; i < count; i++) {
        const status_t up = axis_availability(view->robot, &view->snapshot, kind, i, true);
        const status_t down = axis_availability(view->robot, &view->snapshot, kind, i, false);
        const json_axis_availability_t also = {
            .axis = view->robot->axes[i].name,
            .upwards = name_of(up),
            .upwards_reason = reason_of(up, mode_rows[kind].command),
            .downwards = name_of(down),
            .downwards_reason = reason_of(down, mode_rows[kind].command)};
        (void)cJSON_AddItemToArray(axes, json_axis_availability(&also));
    }
    return axes;
}

static cJSON *new_mode(const telemetry_view_t *view, const int32_t *start_ticks, mode_kind_t kind)
{
    const mode_row_t *row = &mode_rows[kind];
    const status_t status = mode_availability(view->robot, &view->snapshot, start_ticks, kind);
    const json_mode_t also = {.name = mode_kind_name((int32_t)kind),
                              .says = mode_kind_text((int32_t)kind),
                              .command = command_kind_name((int32_t)row->command),
                              .workphases = new_workphases(row->workphases),
                              .is_allowed = status == STATUS_OK,
                              .status = name_of(status),
                              .reason = reason_of(status, row->command),
                              .axes = new_axes(view, kind)};
    return json_mode(&also);
}

static cJSON *new_step(const telemetry_view_t *view, workphase_t workphase)
{
    const status_t status = workphase_availability(view->robot, &view->snapshot, workphase);
    const json_step_t also = {.name = workphase_name((int32_t)workphase),
                              .says = workphase_text((int32_t)workphase),
                              .is_allowed = status == STATUS_OK,
                              .status = name_of(status),
                              .reason = reason_of(status, (uint32_t)COMMAND_WORKPHASE)};
    return json_step(&also);
}

static cJSON *new_steps(const telemetry_view_t *view)
{
    cJSON *steps = cJSON_CreateArray();
    for (uint32_t i = (uint32_t)WORKPHASE_UNDEFINED + 1U; i < WORKPHASE_COUNT; i++) {
        (void)cJSON_AddItemToArray(steps, new_step(view, (workphase_t)i));
    }
    return steps;
}

/* The route that sends it, if it is listed; NULL: none. */
static const route_t *route_of(command_kind_t kind)
{
    const route_t *found = NULL;
    for (uint32_t i = 0U; (i < ROUTE_COUNT) && (found == NULL); i++) {
        const bool is_meant = routes[i].is_listed && (routes[i].command == (uint32_t)kind);
        found = is_meant ? &routes[i] : NULL;
    }
    return found;
}

/* `least`: the role that it needs. Without a session none stands against it. */
static cJSON *new_command(const telemetry_view_t *view, const session_t *session,
                          command_kind_t kind, role_t least)
{
    const status_t status = command_availability(view->robot, &view->snapshot, kind);
    const bool is_of_role = !session->is_open || (session->account.role >= least);
    json_allowed_command_t also = {.name = command_kind_name((int32_t)kind)};
    if (!is_of_role) {
        also.status = problems[PROBLEM_ROLE_REFUSED].code;
        also.reason = problems[PROBLEM_ROLE_REFUSED].detail;
    } else if (status != STATUS_OK) {
        also.status = status_name((int32_t)status);
        also.reason = reason_of(status, (uint32_t)kind);
    } else {
        also.is_allowed = true;
    }
    return json_allowed_command(&also);
}

static cJSON *new_commands(http_server_t *server, const http_call_t *call,
                           const telemetry_view_t *view)
{
    cJSON *commands = cJSON_CreateArray();
    session_t session = {.is_open = false};
    (void)http_login_gate_find(server, call->connection, &session);
    for (uint32_t i = (uint32_t)COMMAND_NONE + 1U; i < COMMAND_KIND_COUNT; i++) {
        const route_t *route = route_of((command_kind_t)i);
        if ((route != NULL) && (mode_of_command(i) == MODE_NONE)) {
            (void)cJSON_AddItemToArray(commands,
                                       new_command(view, &session, (command_kind_t)i, route->role));
        }
    }
    return commands;
}

/**
 * Returns the status sent.
 *
 * @satisfies SWR-HTTP-056
 * @satisfies SWR-MODE-004
 */
int http_modes_show(http_server_t *server, const http_call_t *call)
{
    telemetry_view_t view;
    telemetry_look(&server->telemetry, &view);
    if (!view.has_snapshot) {
        return http_reply_refuse(call->connection, PROBLEM_NO_DATA);
    }
    trajectory_row_t start;
    const bool has_start = exchange_read_start(server->telemetry.exchange, &start);
    cJSON *modes = cJSON_CreateArray();
    for (uint32_t i = (uint32_t)MODE_NONE + 1U; i < MODE_KIND_COUNT; i++) {
        (void)cJSON_AddItemToArray(modes,
                                   new_mode(&view, has_start ? start.ticks : NULL, (mode_kind_t)i));
    }
    const json_modes_t also = {.workphases = new_steps(&view),
                               .modes = modes,
                               .commands = new_commands(server, call, &view)};
    return http_reply_object(call->connection, 200, json_modes(&also));
}
