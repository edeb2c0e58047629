/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_motion.h"

#include "http/http_act.h"
#include "http/telemetry_units.h"

int http_motion_workphase(http_server_t *server, const http_call_t *call)
{
    const request_next_workphase_t *body = &call->body.workphase;
    const command_t command = {
        .id = body->id, .kind = (uint32_t)COMMAND_WORKPHASE, .argument = body->workphase};
    return http_act_command(server, call, &command);
}

int http_motion_jog(http_server_t *server, const http_call_t *call)
{
    const request_jog_t *body = &call->body.jog;
    const axis_config_t *axis = &exchange_robot(server->exchange)->axes[call->path.axis];
    command_t command = {
        .id = body->id, .kind = (uint32_t)COMMAND_JOG, .argument = call->path.axis};
    return telemetry_units_ticks(axis, body->position, &command.value)
               ? http_act_command(server, call, &command)
               : http_act_refuse_member(call, "/position");
}

int http_motion_axis(http_server_t *server, const http_call_t *call, command_kind_t kind,
                     uint32_t id)
{
    const command_t command = {.id = id, .kind = (uint32_t)kind, .argument = call->path.axis};
    return http_act_command(server, call, &command);
}

int http_motion_retract(http_server_t *server, const http_call_t *call)
{
    const command_t command = {.id = call->body.retract.id, .kind = (uint32_t)COMMAND_RETRACT};
    return http_act_command(server, call, &command);
}
