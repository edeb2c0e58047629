/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes of what was recorded: the log of events, its files, and the recordings. */
#include "interface/app/handlers.h"

#include "recording/archive/archive_folder.h"
#include "recording/archive/log_csv.h"
#include "recording/archive/log_search.h"
#include "common/utc_text.h"
#include "exchange/exchange_files.h"
#include "http/call/http_login_gate.h"
#include "http/call/http_download.h"
#include "http/call/http_reply.h"
#include "http/view/telemetry_json.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LOG_DEFAULT 200U
#define CSV_DEFAULT 10000U
#define ROBOT_SIZE 64U /* With each byte escaped. */

/* A request to the two routes of the log. */
typedef struct {
    bool has_after;
    uint32_t after;
    uint32_t limit;
    uint32_t level;
    const char *text; /* NULL: any. */
    const char *from; /* The same. */
    const char *to;   /* The same. */
} asked_t;

/* The queries are of two types, with the same members. */
#define ASKED(query, limit_default)                                                                \
    {                                                                                              \
        .has_after = (query).has_after, .after = (query).after,                                    \
        .limit = (query).has_limit ? (query).limit : (limit_default),                              \
        .level = (query).has_level ? (query).level : 0U,                                           \
        .text = (query).has_text ? (query).text : NULL,                                            \
        .from = (query).has_from ? (query).from : NULL, .to = (query).has_to ? (query).to : NULL   \
    }

static bool take_place(uint32_t *taken, uint32_t most)
{
    const bool is_free = __atomic_add_fetch(taken, 1U, __ATOMIC_ACQ_REL) <= most;
    if (!is_free) {
        (void)__atomic_sub_fetch(taken, 1U, __ATOMIC_ACQ_REL);
    }
    return is_free;
}

static void give_place(uint32_t *taken)
{
    (void)__atomic_sub_fetch(taken, 1U, __ATOMIC_ACQ_REL);
}

static bool read_time(const char *text, uint64_t *utc_us, const char *parameter,
                      request_result_t *fault)
{
    if ((text == NULL) || utc_text_read(text, utc_us)) {
        return true;
    }
    request_fault_set(fault, REQUEST_WRONG_TYPE, NULL);
    (void)snprintf(fault->place, sizeof fault->place, "%s", parameter);
    return false;
}

static bool read_filter(const asked_t *asked, log_filter_t *filter, request_result_t *fault)
{
    const log_filter_t read = {.has_after = asked->has_after,
                               .after = asked->after,
                               .limit = asked->limit,
                               .severity = asked->level,
                               .text = asked->text,
                               .to_us = UINT64_MAX};
    *filter = read;
    return read_time(asked->from, &filter->from_us, "from", fault) &&
           read_time(asked->to, &filter->to_us, "to", fault);
}

/* In files only if it has to be. `problem` is set if it cannot be done. */
static bool search(http_server_t *server, const log_filter_t *filter, uint32_t events,
                   log_search_t *found, problem_t *problem)
{
    *problem = PROBLEM_NO_MEMORY;
    bool is_done = log_search(found, filter, server->exchange, events, NULL);
    if (is_done && found->wants_files) {
        log_search_end(found);
        *problem = PROBLEM_ARCHIVE_BUSY;
        is_done = take_place(&server->archive.searches, LIMIT_ARCHIVE_SEARCHES);
        if (is_done) {
            *problem = PROBLEM_NO_MEMORY;
            is_done =
                log_search(found, filter, server->exchange, events, server->archive.directory);
            give_place(&server->archive.searches);
        }
    }
    return is_done;
}

/* Finds the requested file; 0, or the status of the refusal that was sent. */
static int find_events(http_server_t *server, struct mg_connection *connection,
                       const asked_t *asked, log_filter_t *filter, log_search_t *found)
{
    telemetry_view_t view;
    request_result_t fault = {.fault = REQUEST_OK};
    problem_t problem;
    telemetry_look(&server->telemetry, &view);
    if (!view.has_snapshot) {
        return http_reply_refuse(connection, PROBLEM_NO_DATA);
    }
    if (!read_filter(asked, filter, &fault)) {
        const http_problem_t reported = http_problem_of_query(&fault);
        return http_reply_problem(connection, &reported, NULL);
    }
    return search(server, filter, view.snapshot.events, found, &problem)
               ? 0
               : http_reply_refuse(connection, problem);
}

/**
 * Each answers its route.
 *
 * @return the status sent
 *
 * @satisfies SWR-HTTP-041
 */
int http_archive_log(http_server_t *server, const http_call_t *call)
{
    const asked_t asked = ASKED(call->query.log, LOG_DEFAULT);
    const robot_t *robot = exchange_robot(server->exchange);
    log_filter_t filter;
    log_search_t found;
    const int status = find_events(server, call->connection, &asked, &filter, &found);
    if (status != 0) {
        return status;
    }
    cJSON *entries = cJSON_CreateArray();
    for (uint32_t i = 0U; i < found.count; i++) {
        (void)cJSON_AddItemToArray(entries,
                                   telemetry_json_event(robot, log_search_entry(&found, i)));
    }
    const json_log_t log = {.entries = entries, .next = found.next, .lost = found.lost};
    log_search_end(&found);
    return http_reply_object(call->connection, 200, json_log(&log));
}

/** @satisfies SWR-HTTP-042 */
int http_archive_log_csv(http_server_t *server, const http_call_t *call)
{
    const asked_t asked = ASKED(call->query.log_csv, CSV_DEFAULT);
    log_filter_t filter;
    log_search_t found;
    size_t size = 0U;
    const int status = find_events(server, call->connection, &asked, &filter, &found);
    if (status != 0) {
        return status;
    }
    char *text = log_csv_write(&found, exchange_robot(server->exchange), &size);
    log_search_end(&found);
    const http_reply_t reply = {.status = 200,
                                .type = "text/csv; charset=utf-8; header=present",
                                .cache = HTTP_REPLY_NO_STORE,
                                .file_name = "events.csv",
                                .body = text,
                                .size = size};
    const int sent = (text != NULL) ? http_reply_send(call->connection, &reply)
                                    : http_reply_refuse(call->connection, PROBLEM_NO_MEMORY);
    free(text);
    return sent;
}

static const char *write_utc(bool is_known, uint64_t utc_us, char text[UTC_TEXT_SIZE])
{
    utc_text_write(utc_us, text);
    return is_known ? text : NULL;
}

static cJSON *new_log(const archive_log_t *log)
{
    char first[UTC_TEXT_SIZE];
    char last[UTC_TEXT_SIZE];
    const json_log_file_t reported = {.name = log->name,
                                      .bytes = log->bytes,
                                      .first = write_utc(log->has_lines, log->first_us, first),
                                      .last = write_utc(log->has_lines, log->last_us, last),
                                      .is_present = log->is_present};
    return json_log_file(&reported);
}

static cJSON *new_logs(const http_server_t *server)
{
    archive_log_t *logs = malloc(LIMIT_EVENT_LOGS * sizeof *logs);
    cJSON *list = cJSON_CreateArray();
    const uint32_t count =
        (logs != NULL) ? archive_list_logs(server->archive.directory,
                                           exchange_file(server->exchange, EXCHANGE_FILE_LOG), logs,
                                           LIMIT_EVENT_LOGS)
                       : 0U;
    for (uint32_t i = 0U; i < count; i++) {
        (void)cJSON_AddItemToArray(list, new_log(&logs[i]));
    }
    free(logs);
    const json_logs_t reported = {.logs = list};
    return json_logs(&reported);
}

static cJSON *new_recording(const archive_recording_t *recording)
{
    char started[UTC_TEXT_SIZE];
    char robot[ROBOT_SIZE + 1U];
    recording_escape(recording->robot, robot, sizeof robot);
    const json_recording_t reported = {
        .name = recording->name,
        .bytes = recording->bytes,
        .started = write_utc(recording->is_known, recording->started_us, started),
        .robot = recording->is_known ? robot : NULL,
        .is_present = recording->is_present};
    return json_recording(&reported);
}

static cJSON *new_recordings(const http_server_t *server)
{
    archive_recording_t *recordings = malloc(LIMIT_RECORDINGS * sizeof *recordings);
    cJSON *list = cJSON_CreateArray();
    const uint32_t present = exchange_file(server->exchange, EXCHANGE_FILE_RECORDING);
    const uint32_t count = (recordings != NULL)
                               ? archive_list_recordings(server->archive.directory, present,
                                                         recordings, LIMIT_RECORDINGS)
                               : 0U;
    for (uint32_t i = 0U; i < count; i++) {
        (void)cJSON_AddItemToArray(list, new_recording(&recordings[i]));
    }
    free(recordings);
    const json_recordings_t reported = {.recordings = list};
    return json_recordings(&reported);
}

/* A list is a search, too. */
static int answer_list(http_server_t *server, struct mg_connection *connection,
                       cJSON *(*new_list)(const http_server_t *))
{
    if (!take_place(&server->archive.searches, LIMIT_ARCHIVE_SEARCHES)) {
        return http_reply_refuse(connection, PROBLEM_ARCHIVE_BUSY);
    }
    cJSON *list = new_list(server);
    give_place(&server->archive.searches);
    return http_reply_object(connection, 200, list);
}

/** @satisfies SWR-HTTP-043 */
int http_archive_logs(http_server_t *server, const http_call_t *call)
{
    return answer_list(server, call->connection, new_logs);
}

/** @satisfies SWR-HTTP-044 */
int http_archive_recordings(http_server_t *server, const http_call_t *call)
{
    return answer_list(server, call->connection, new_recordings);
}

static int answer_file(http_server_t *server, const http_call_t *call, const file_series_t *series,
                       const char *type)
{
    archive_file_t file;
    if (!take_place(&server->archive.downloads, LIMIT_DOWNLOADS)) {
        return http_reply_refuse(call->connection, PROBLEM_ARCHIVE_BUSY);
    }
    const uint32_t present = exchange_file(server->exchange, EXCHANGE_FILE_RECORDING);
    const bool is_there =
        archive_open(&file, server->archive.directory, series, call->path.name, present);
    const int status = is_there ? http_download_send(call->connection, &file, type)
                                : http_reply_refuse(call->connection, PROBLEM_NOT_THERE);
    give_place(&server->archive.downloads);
    return status;
}

int http_archive_log_file(http_server_t *server, const http_call_t *call)
{
    return answer_file(server, call, &file_series_logs, "text/plain; charset=utf-8");
}

int http_archive_recording(http_server_t *server, const http_call_t *call)
{
    return answer_file(server, call, &file_series_recordings, "application/octet-stream");
}

/* The refusal for a page that sets the level; NULL: nothing is against it. */
static const char *reason_against_setting(http_server_t *server, const http_call_t *call)
{
    session_t session;
    if (!http_login_gate_find(server, call->connection, &session)) {
        return problems[PROBLEM_NO_SESSION].detail;
    }
    return (session.account.role < routes[ROUTE_SET_LOG_LEVEL].role)
               ? problems[PROBLEM_ROLE_REFUSED].detail
               : NULL;
}

/** @satisfies SWR-HTTP-049 */
int http_archive_log_level(http_server_t *server, const http_call_t *call)
{
    (void)pthread_mutex_lock(&server->archive.lock);
    const exchange_log_level_t level = server->archive.level;
    (void)pthread_mutex_unlock(&server->archive.lock);
    const json_log_level_t reported = {.level = event_severity_name((int32_t)level.severity),
                                       .by = (level.by[0] != '\0') ? level.by : NULL,
                                       .reason = reason_against_setting(server, call)};
    return http_reply_object(call->connection, 200, json_log_level(&reported));
}

int http_archive_set_log_level(http_server_t *server, const http_call_t *call)
{
    exchange_log_level_t level = {.severity = call->body.set_log_level.level};
    session_t session;
    if (!http_login_gate_find(server, call->connection, &session)) {
        return http_reply_refuse(call->connection, PROBLEM_NO_SESSION);
    }
    (void)snprintf(level.by, sizeof level.by, "%s", session.account.name);
    (void)pthread_mutex_lock(&server->archive.lock);
    server->archive.level = level;
    exchange_set_log_level(server->exchange, &level);
    (void)pthread_mutex_unlock(&server->archive.lock);
    return http_archive_log_level(server, call);
}
