/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_program.h"

#include "common/axis_terms.h"
#include "http/http_act.h"
#include "http/http_reply.h"
#include "http/patience.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "mode/program_list.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define POINTER_SIZE 24U
#define MS_PER_S 1000.0
#define US_PER_S 1e6

static int show(const http_call_t *call, const snapshot_t *snapshot)
{
    const bool is_held = snapshot->program_steps != 0U;
    const json_program_t also = {
        .source = is_held ? command_source_name((int32_t)snapshot->program_source) : NULL,
        .dwelt_s = (double)snapshot->program_dwelt_us / US_PER_S};
    return http_reply_object(call->connection, 200, json_program(snapshot, &also));
}

int http_program_show(http_server_t *server, const http_call_t *call)
{
    snapshot_t snapshot;
    return exchange_read_snapshot(server->exchange, &snapshot)
               ? show(call, &snapshot)
               : http_reply_refuse(call->connection, PROBLEM_NO_DATA);
}

/* `pointer` leads to the step, NULL: to none. */
static int refuse(http_server_t *server, const http_call_t *call, const answer_t *answer,
                  const char *pointer)
{
    http_problem_t problem = http_problem_of_status(answer->status);
    problem.pointer = pointer;
    problem.axis = http_act_axis(exchange_robot(server->exchange), answer);
    problem.limit = http_act_limit(answer);
    return http_reply_problem(call->connection, &problem, NULL);
}

/* 0 once it was taken, otherwise the status of the refusal that was sent. */
static int command(http_server_t *server, const http_call_t *call, const command_t *sent,
                   const char *pointer)
{
    answer_t answer;
    switch (act_desk_do(&server->acts, call->page, sent, &answer)) {
    case ACT_ANSWERED:
        return (answer.kind == (uint32_t)ANSWER_REFUSED) ? refuse(server, call, &answer, pointer)
                                                         : 0;
    case ACT_LATER:
        return http_reply_refuse(call->connection, PROBLEM_BUSY);
    case ACT_ID_USED:
    case ACT_NO_ANSWER:
    default:
        return http_reply_refuse(call->connection, PROBLEM_NO_ANSWER);
    }
}

/* In ticks; false when a number is outside of what an axis can be told, or the angle is missing
 * where there is an axis for it, or too much. */
static bool read_step(const robot_t *robot, const request_program_step_t *asked,
                      program_step_t *step)
{
    const uint32_t turning = program_list_turning_axis(robot);
    (void)memset(step, 0, sizeof *step);
    step->dwell_ms = (uint32_t)round(asked->dwell_s * MS_PER_S);
    step->is_gated = asked->gate ? 1U : 0U;
    if (asked->has_angle != (turning < robot->axis_count)) {
        return false;
    }
    return axis_terms_ticks(&robot->axes[robot->needle_axis], asked->depth, &step->depth_ticks) &&
           (!asked->has_angle ||
            axis_terms_ticks(&robot->axes[turning], asked->angle, &step->angle_ticks));
}

static command_t command_of(const robot_t *robot, const program_step_t *step, uint32_t index)
{
    const uint32_t turning = program_list_turning_axis(robot);
    const int32_t dwell_ms = (int32_t)step->dwell_ms;
    command_t sent = {.kind = (uint32_t)COMMAND_PROGRAM_STEP,
                      .argument = index,
                      .value = (step->is_gated != 0U) ? -dwell_ms : dwell_ms};
    sent.ticks[robot->needle_axis] = step->depth_ticks;
    if (turning < robot->axis_count) {
        sent.ticks[turning] = step->angle_ticks;
    }
    return sent;
}

/* A gate without a dwell is none in a command. */
static int send_steps(http_server_t *server, const http_call_t *call, uint32_t *crc)
{
    const robot_t *robot = exchange_robot(server->exchange);
    const request_program_t *body = &call->body.send_program;
    char pointer[POINTER_SIZE];
    int status = 0;
    for (uint32_t i = 0U; (i < body->steps_count) && (status == 0); i++) {
        program_step_t step;
        (void)snprintf(pointer, sizeof pointer, "/steps/%u", (unsigned)i);
        if (!read_step(robot, &body->steps[i], &step) ||
            ((step.is_gated != 0U) && (step.dwell_ms == 0U))) {
            return http_act_refuse_member(call, pointer);
        }
        const command_t sent = command_of(robot, &step, i);
        *crc = program_list_crc(*crc, &step);
        status = command(server, call, &sent, pointer);
    }
    return status;
}

/* Answers are there before the snapshot that shows what they say. */
static int show_held(http_server_t *server, const http_call_t *call, uint32_t steps)
{
    const uint32_t looks = patience_looks(server->exchange);
    snapshot_t snapshot;
    for (uint32_t i = 0U; i < looks; i++) {
        if (exchange_read_snapshot(server->exchange, &snapshot) &&
            (snapshot.program_steps == steps)) {
            return show(call, &snapshot);
        }
        patience_wait();
    }
    return http_reply_refuse(call->connection, PROBLEM_NO_ANSWER);
}

int http_program_send(http_server_t *server, const http_call_t *call)
{
    const uint32_t count = call->body.send_program.steps_count;
    const command_t begin = {.kind = (uint32_t)COMMAND_PROGRAM_BEGIN, .argument = count};
    command_t end = {.kind = (uint32_t)COMMAND_PROGRAM_END};
    int status = command(server, call, &begin, NULL);
    if (status == 0) {
        status = send_steps(server, call, &end.argument);
    }
    if (status == 0) {
        status = command(server, call, &end, NULL);
    }
    return (status == 0) ? show_held(server, call, count) : status;
}

int http_program_empty(http_server_t *server, const http_call_t *call)
{
    const command_t nothing = {.kind = (uint32_t)COMMAND_PROGRAM_BEGIN};
    const int status = command(server, call, &nothing, NULL);
    return (status == 0) ? show_held(server, call, 0U) : status;
}

int http_program_run(http_server_t *server, const http_call_t *call)
{
    const request_run_program_t *body = &call->body.run_program;
    const command_t run = {
        .id = body->id, .kind = (uint32_t)COMMAND_RUN_PROGRAM, .argument = body->checksum};
    return http_act_command(server, call, &run);
}
