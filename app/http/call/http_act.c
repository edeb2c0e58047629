/* SPDX-License-Identifier: Apache-2.0 */
#include "http/call/http_act.h"

#include "http/call/http_login_gate.h"
#include "http/call/http_reply.h"
#include "http/view/telemetry_units.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "request/request_headers.h"

#define NOT_SENT 499
#define UNIT_SIZE 96U
#define RANGE_SIZE 96U

static int refuse(struct mg_connection *connection, problem_t problem)
{
    const int status = http_reply_refuse(connection, problem);
    return (status != 0) ? status : NOT_SENT;
}

/* The page that has authority; 0: none has. */
static uint32_t holder_of(const http_server_t *server)
{
    snapshot_t snapshot;
    const bool is_page = exchange_read_snapshot(server->exchange, &snapshot) &&
                         (snapshot.holder == (uint32_t)COMMAND_SOURCE_HTTP);
    return is_page ? snapshot.holder_peer : 0U;
}

int http_act_judge(http_server_t *server, http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    session_t session;
    if (!call->route->is_of_page) {
        return 0;
    }
    if (!request_headers_number(mg_get_header(connection, HTTP_ACT_PAGE), &call->page) ||
        (call->page == 0U)) {
        return refuse(connection, PROBLEM_PAGE_MISSING);
    }
    if (!http_login_gate_find(server, connection, &session)) {
        return refuse(connection, PROBLEM_NO_SESSION);
    }
    const uint32_t holder = holder_of(server);
    const page_verdict_t verdict =
        command_client_register_page(&server->acts, call->page, &session, holder);
    if (verdict != PAGE_GREETED) {
        return refuse(connection, (verdict == PAGE_ANOTHERS) ? PROBLEM_PAGE_REFUSED : PROBLEM_BUSY);
    }
    return (call->route->needs_authority && (holder != call->page))
               ? refuse(connection, PROBLEM_NO_AUTHORITY)
               : 0;
}

const char *http_act_axis(const robot_t *robot, const answer_t *answer)
{
    const uint32_t axis = answer_axis(answer);
    return (axis < robot->axis_count) ? robot->axes[axis].name : NULL;
}

const char *http_act_limit(const answer_t *answer)
{
    if (answer_form(answer) != ANSWER_FORM_LIMIT) {
        return NULL;
    }
    return (answer_as_limit(answer)->is_maximum != 0U) ? "upper" : "lower";
}

/* An act that was begun is not done yet, though nothing is against it. */
static const char *message_of(const answer_t *answer)
{
    const bool is_begun = (answer->kind == (uint32_t)ANSWER_ACCEPTED) && (answer->is_final == 0U);
    return is_begun ? "Accepted; its end is reported later." : status_text((int32_t)answer->status);
}

static const char *state_of(const answer_t *answer)
{
    const bool is_good =
        (answer->kind == (uint32_t)ANSWER_ACCEPTED) || (answer->kind == (uint32_t)ANSWER_DONE);
    if (!is_good) {
        return "failed";
    }
    return (answer->is_final != 0U) ? "done" : "accepted";
}

cJSON *http_act_report(const robot_t *robot, uint32_t page, uint32_t id, const answer_t *answer)
{
    const json_act_t reported = {.id = id,
                                 .page = page,
                                 .state = state_of(answer),
                                 .code = status_name((int32_t)answer->status),
                                 .message = message_of(answer),
                                 .axis = http_act_axis(robot, answer),
                                 .limit = http_act_limit(answer),
                                 .workphase = workphase_name((int32_t)answer->workphase)};
    return json_act(&reported);
}

int http_act_refuse(http_server_t *server, const http_call_t *call, const answer_t *answer)
{
    http_problem_t problem = http_problem_of_status(answer->status);
    problem.axis = http_act_axis(exchange_robot(server->exchange), answer);
    problem.limit = http_act_limit(answer);
    return http_reply_problem(call->connection, &problem, NULL);
}

/* A refusal at once is a problem. */
static int reply(http_server_t *server, const http_call_t *call, uint32_t id,
                 const answer_t *answer)
{
    const robot_t *robot = exchange_robot(server->exchange);
    if (answer->kind == (uint32_t)ANSWER_REFUSED) {
        return http_act_refuse(server, call, answer);
    }
    return http_reply_object(call->connection, (answer->is_final != 0U) ? 200 : 202,
                             http_act_report(robot, call->page, id, answer));
}

int http_act_refuse_member(const http_call_t *call, const char *pointer)
{
    http_problem_t problem = http_problem_of(PROBLEM_OUT_OF_RANGE);
    problem.pointer = pointer;
    return http_reply_problem(call->connection, &problem, NULL);
}

int http_act_refuse_range(const http_call_t *call, const char *pointer, const char *expected)
{
    char detail[RANGE_SIZE];
    http_problem_t problem = http_problem_of(PROBLEM_OUT_OF_RANGE);
    (void)snprintf(detail, sizeof detail, "This is outside its range. Expected is %s.", expected);
    problem.detail = detail;
    problem.pointer = pointer;
    return http_reply_problem(call->connection, &problem, NULL);
}

int http_act_refuse_unit(const http_call_t *call, const axis_config_t *axis, const char *pointer)
{
    char detail[UNIT_SIZE];
    http_problem_t problem = http_problem_of(PROBLEM_WRONG_UNIT);
    (void)snprintf(detail, sizeof detail, "Axis %s goes in %s: its numbers need \"unit\": \"%s\".",
                   axis->name, telemetry_units_name(axis), telemetry_units_name(axis));
    problem.detail = detail;
    problem.pointer = pointer;
    problem.axis = axis->name;
    return http_reply_problem(call->connection, &problem, NULL);
}

int http_act_refuse_choice(const http_call_t *call, bool has_both, const char *pointer)
{
    request_result_t fault;
    request_fault_set(&fault, has_both ? REQUEST_UNKNOWN : REQUEST_MISSING, NULL);
    (void)snprintf(fault.place, sizeof fault.place, "%s", pointer);
    const http_problem_t problem = http_problem_of_body(&fault);
    return http_reply_problem(call->connection, &problem, NULL);
}

int http_act_command(http_server_t *server, const http_call_t *call, const command_t *command)
{
    answer_t answer;
    switch (
        command_client_send_and_wait(&server->acts, call->page, command->id, command, &answer)) {
    case ACT_ANSWERED:
        return reply(server, call, command->id, &answer);
    case ACT_ID_USED:
        return http_reply_refuse(call->connection, PROBLEM_ID_USED);
    case ACT_LATER:
        return http_reply_refuse(call->connection, PROBLEM_BUSY);
    case ACT_NO_ANSWER:
    default:
        return http_reply_refuse(call->connection, PROBLEM_NO_ANSWER);
    }
}
