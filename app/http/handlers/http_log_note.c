/* SPDX-License-Identifier: Apache-2.0 */
#include "http/handlers/http_log_note.h"

#include "exchange/exchange_notes.h"
#include "http/call/http_act.h"
#include "http/call/http_login_gate.h"
#include "http/call/http_reply.h"
#include "interface/app/handlers.h"
#include "limits/requirement_limits.h"

#include <string.h>

/* U+0080 to U+009F, U+2028 to U+202E, U+2066 to U+2069. */
static bool is_hidden(const char *at)
{
    const unsigned char *bytes = (const unsigned char *)at;
    const bool is_control = (bytes[0] == 0xC2U) && (bytes[1] < 0xA0U);
    const bool is_line_or_way =
        (strncmp(at, "\xE2\x80", 2U) == 0) && (bytes[2] >= 0xA8U) && (bytes[2] <= 0xAEU);
    const bool is_way =
        (strncmp(at, "\xE2\x81", 2U) == 0) && (bytes[2] >= 0xA6U) && (bytes[2] <= 0xA9U);
    return (bytes[0] < 0x20U) || (bytes[0] == 0x7FU) || is_control || is_line_or_way || is_way;
}

bool http_log_note_is_plain(const char *text)
{
    bool is_plain = text[0] != '\0';
    for (const char *byte = text; *byte != '\0'; byte++) {
        is_plain = is_plain && !is_hidden(byte);
    }
    return is_plain;
}

/* The number of the note that this act has written before; 0: none, or with other words. */
static uint32_t find_earlier(http_server_t *server, const http_call_t *call)
{
    const request_log_note_t *body = &call->body.log_note;
    command_t command;
    exchange_note_t note;
    const bool is_same =
        command_client_recall(&server->acts, call->page, body->id, &command) &&
        (command.kind == (uint32_t)COMMAND_NOTE) &&
        exchange_read_note(server->exchange, (uint32_t)command.as.note.number, &note) &&
        (strcmp(note.text, body->text) == 0);
    return is_same ? (uint32_t)command.as.note.number : 0U;
}

static int refuse_for_now(const http_call_t *call)
{
    http_problem_t problem = http_problem_of(PROBLEM_NOTE_TOO_SOON);
    problem.retry_after_s = LIMIT_NOTE_PAUSE_MS / 1000U;
    return http_reply_problem(call->connection, &problem, NULL);
}

/**
 * Writes the note, as an act of its page.
 *
 * @return the status sent
 *
 * @satisfies SWR-EVENT-012
 */
int http_log_note_write(http_server_t *server, const http_call_t *call)
{
    const request_log_note_t *body = &call->body.log_note;
    uint32_t number = find_earlier(server, call);
    session_t session;
    if (!http_log_note_is_plain(body->text)) {
        return http_act_refuse_member(call, "/text");
    }
    if (!http_login_gate_find(server, call->connection, &session)) {
        return http_reply_refuse(call->connection, PROBLEM_NO_SESSION);
    }
    if (number == 0U) {
        number =
            http_notes_keep(&server->notes, session.account.name, body->text, telemetry_now_ms());
    }
    const command_t command = {
        .id = body->id,
        .kind = (uint32_t)COMMAND_NOTE,
        .as.note = {.note = (uint32_t)NOTE_OPERATOR, .number = (int32_t)number}};
    return (number != 0U) ? http_act_command(server, call, &command) : refuse_for_now(call);
}
