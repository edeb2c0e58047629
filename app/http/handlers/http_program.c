/* SPDX-License-Identifier: Apache-2.0 */
/** @file The treatment program that is held: shown, sent, emptied, run. */
#include "interface/app/handlers.h"

#include "common/list_terms.h"
#include "http/call/http_act.h"
#include "http/handlers/http_list.h"
#include "http/call/http_reply.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "mode/lists/program_step.h"

#include <stdio.h>

#define US_PER_S 1e6

static int show(const http_call_t *call, const snapshot_t *snapshot)
{
    const bool is_held = snapshot->program_steps != 0U;
    const json_program_t also = {
        .source = is_held ? command_source_name((int32_t)snapshot->program_source) : NULL,
        .dwelt_s = (double)snapshot->program_dwelt_us / US_PER_S};
    return http_reply_object(call->connection, 200, json_program(snapshot, &also));
}

static uint32_t held(const snapshot_t *snapshot)
{
    return snapshot->program_steps;
}

static bool item(const robot_t *robot, const void *items, uint32_t index, command_t *command,
                 uint32_t *crc)
{
    const request_program_step_t *asked = &((const request_program_step_t *)items)[index];
    const reported_step_t reported = {.depth_mm = asked->depth_mm,
                                      .has_angle = asked->has_angle_deg,
                                      .angle_deg = asked->angle_deg,
                                      .dwell_s = asked->dwell_s,
                                      .is_gated = asked->gate};
    program_step_t step;
    const bool is_one = list_terms_step(robot, &reported, &step) == STATUS_OK;
    if (is_one) {
        *command = list_terms_step_command(robot, index, &step);
        *crc = program_list_crc(*crc, &step);
    }
    return is_one;
}

static void point(uint32_t index, char pointer[HTTP_LIST_POINTER_SIZE])
{
    (void)snprintf(pointer, HTTP_LIST_POINTER_SIZE, "/steps/%u", (unsigned)index);
}

static const http_list_t program = {
    COMMAND_PROGRAM_BEGIN, COMMAND_PROGRAM_END, show, held, item, point};

int http_program_show(http_server_t *server, const http_call_t *call)
{
    return http_list_show(server, call, &program);
}

/**
 * Sends the steps of the body, some at once and the next ones when these were taken.
 *
 * @satisfies SWR-PROG-012
 */
int http_program_send(http_server_t *server, const http_call_t *call)
{
    const request_program_t *body = &call->body.send_program;
    return http_list_send(server, call, &program, body->steps, body->steps_count);
}

int http_program_empty(http_server_t *server, const http_call_t *call)
{
    return http_list_empty(server, call, &program);
}
