/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a request and its answer are one bounded note without secrets, and a flood of
 * them leaves their number. */
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_peers.h"
#include "http/pages/command_client.h"
#include "http/pages/http_notes.h"
#include "http/pages/http_record.h"
#include "http/pages/http_peers_log.h"
#include "http/call/http_transaction.h"
#include "limits/requirement_limits.h"
#include "http/login/session_store.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define NOW_MS UINT64_C(1000000)

static exchange_t *control;
static exchange_t *server;
static char name[32];
static char error[256];
static command_client_t client;
static http_notes_t notes;
static http_record_t record;
static http_peers_log_t statuses;
static char text[1024];
static void *own_data;

/* The library of HTTP, as far as it is asked here. */
void mg_set_user_connection_data(const struct mg_connection *connection, void *data)
{
    (void)connection;
    own_data = data;
}

void *mg_get_user_connection_data(const struct mg_connection *connection)
{
    (void)connection;
    return own_data;
}

void setUp(void)
{
    (void)snprintf(name, sizeof name, "test-http-record-%d", (int)getpid());
    control = exchange_create(name, 64U, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(control, error);
    server = exchange_open(name, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(server, error);
    command_client_init(&client, server);
    http_notes_init(&notes, server, &client);
    http_record_init(&record, &notes, NOW_MS);
    http_peers_log_init(&statuses, &notes);
    own_data = NULL;
}

void tearDown(void)
{
    exchange_close(server);
    exchange_close(control);
}

static http_record_entry_t command_of(const char *who)
{
    const http_record_entry_t entry = {.who = who,
                                       .method = "POST",
                                       .path = "/api/v1/targeting/entry",
                                       .request = "{\"id\":1}",
                                       .status = 200,
                                       .answer = "{\"id\":1,\"state\":\"done\"}"};
    return entry;
}

static void expect_newest(uint32_t number, const char *who, const char *sentence)
{
    exchange_note_t note;
    TEST_ASSERT_EQUAL_UINT32(number, exchange_newest_note(server));
    TEST_ASSERT_TRUE(exchange_read_note(control, number, &note));
    TEST_ASSERT_EQUAL_UINT32(NOTE_TRANSACTION, note.kind);
    TEST_ASSERT_EQUAL_STRING(who, note.who);
    TEST_ASSERT_EQUAL_STRING(sentence, note.text);
}

static const char *request_text(const char *json)
{
    http_transaction_write_request(text, HTTP_TRANSACTION_REQUEST_SIZE, json, strlen(json));
    return text;
}

void test_SWR_EVENT_018_a_request_and_its_answer_are_one_note(void)
{
    const http_record_entry_t entry = command_of("anna");
    http_record_write(&record, &entry, NOW_MS);
    expect_newest(1U, "anna",
                  "POST /api/v1/targeting/entry {\"id\":1} answered 200 "
                  "{\"id\":1,\"state\":\"done\"}");
}

void test_SWR_EVENT_018_without_body_and_answer_there_are_none(void)
{
    http_record_entry_t entry = command_of(NULL);
    entry.request = "";
    entry.answer = "";
    entry.path = "/a\xE2\x80\xAE\n";
    entry.status = 499;
    http_record_write(&record, &entry, NOW_MS);
    expect_newest(1U, "?", "POST /a???? answered 499");
}

void test_SWR_EVENT_018_secrets_are_hidden(void)
{
    TEST_ASSERT_EQUAL_STRING("{\"id\":1,\"token\":\"***\",\"x\":\"token\"}",
                             request_text("{ \"id\": 1, \"token\" : 77 ,\n\"x\":\"token\"}"));
    TEST_ASSERT_EQUAL_STRING(
        "{\"password\":\"***\",\"code\":\"***\",\"hmac\":\"***\"}",
        request_text("{\"password\":\"a\\\",b\",\"code\":\"c\",\"hmac\":\"d\"}"));
    TEST_ASSERT_EQUAL_STRING("{\"pass\\u0077ord\":\"***\"}",
                             request_text("{\"pass\\u0077ord\":\"secret\"}"));
    TEST_ASSERT_EQUAL_STRING("{\"token\":\"***\"", request_text("{\"token\":{\"a\":1,\"b\":2}}"));
    TEST_ASSERT_EQUAL_STRING("{\"token\":\"***\"", request_text("{\"token\":\"never ends \\"));
}

void test_SWR_EVENT_018_numbers_stay_as_they_were_sent(void)
{
    TEST_ASSERT_EQUAL_STRING("{\"point_mm\":[1.50,-2e1,3],\"a\":\"b c\"}",
                             request_text("{\"point_mm\": [ 1.50, -2e1, 3 ], \"a\":\"b c\"}"));
}

void test_SWR_EVENT_018_what_is_longer_is_cut_with_its_size(void)
{
    char json[2001];
    (void)memset(json, '1', sizeof json);
    http_transaction_write_request(text, HTTP_TRANSACTION_REQUEST_SIZE, json, 2000U);
    TEST_ASSERT_EQUAL_size_t(LIMIT_TRANSACTION_REQUEST_BYTES, strlen(text));
    TEST_ASSERT_EQUAL_STRING("1... (2000 bytes)", &text[strlen(text) - 17U]);
    http_transaction_write_answer(text, HTTP_TRANSACTION_ANSWER_SIZE, json, 2000U);
    TEST_ASSERT_EQUAL_size_t(LIMIT_TRANSACTION_ANSWER_BYTES, strlen(text));
    TEST_ASSERT_EQUAL_STRING("1... (2000 bytes)", &text[strlen(text) - 17U]);
    http_transaction_write_request(text, 2U, json, 2000U);
    TEST_ASSERT_EQUAL_STRING("1", text);
}

void test_SWR_EVENT_018_the_longest_of_all_is_one_note(void)
{
    static char request[HTTP_TRANSACTION_REQUEST_SIZE];
    static char answer[HTTP_TRANSACTION_ANSWER_SIZE];
    static char path[200];
    exchange_note_t note;
    (void)memset(request, 'r', sizeof request - 1U);
    (void)memset(answer, 'a', sizeof answer - 1U);
    (void)memset(path, 'p', sizeof path - 1U);
    http_record_entry_t entry = command_of("anna");
    entry.method = "DELETE";
    entry.path = path;
    entry.request = request;
    entry.answer = answer;
    record.commanded.left_out = UINT32_MAX;
    http_record_write(&record, &entry, NOW_MS);
    TEST_ASSERT_TRUE(exchange_read_note(control, 1U, &note));
    TEST_ASSERT_EQUAL_CHAR('a', note.text[strlen(note.text) - 1U]);
    TEST_ASSERT_NOT_NULL(strstr(note.text, answer));
}

void test_SWR_EVENT_018_a_connection_keeps_what_it_asks_and_is_answered(void)
{
    http_transaction_t transaction;
    http_transaction_begin(&transaction, NULL);
    http_transaction_keep_request(NULL, NULL, 0U);
    TEST_ASSERT_EQUAL_STRING("", transaction.request);
    http_transaction_keep_request(NULL, NULL, 12U);
    TEST_ASSERT_EQUAL_STRING("(12 bytes)", transaction.request);
    http_transaction_keep_request(NULL, "{\"id\":1}", 8U);
    http_transaction_keep_answer(NULL, "{\"id\":2}", 8U);
    http_transaction_end(NULL);
    http_transaction_keep_request(NULL, "{\"id\":3}", 8U);
    http_transaction_keep_answer(NULL, "{\"id\":3}", 8U);
    TEST_ASSERT_EQUAL_STRING("{\"id\":1}", transaction.request);
    TEST_ASSERT_EQUAL_STRING("{\"id\":2}", transaction.answer);
}

static void refuse_many(const char *who, uint32_t count, uint64_t now_ms)
{
    http_record_entry_t entry = command_of(who);
    entry.status = 409;
    for (uint32_t i = 0U; i < count; i++) {
        http_record_write(&record, &entry, now_ms);
    }
}

void test_SWR_EVENT_019_of_a_flood_the_first_and_the_number_are_logged(void)
{
    refuse_many(NULL, LIMIT_REFUSALS_AT_ONCE + 3U, NOW_MS);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_REFUSALS_AT_ONCE, exchange_newest_note(server));
    http_record_tick(&record, NOW_MS + LIMIT_REFUSAL_PAUSE_MS - 1U);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_REFUSALS_AT_ONCE, exchange_newest_note(server));
    http_record_tick(&record, NOW_MS + LIMIT_REFUSAL_PAUSE_MS);
    expect_newest(LIMIT_REFUSALS_AT_ONCE + 1U, "http",
                  "3 requests, refused or a stranger's, came too fast to be logged.");
    http_record_tick(&record, NOW_MS + (3U * LIMIT_REFUSAL_PAUSE_MS));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_REFUSALS_AT_ONCE + 1U, exchange_newest_note(server));
}

void test_SWR_EVENT_019_the_next_that_is_logged_has_the_number(void)
{
    refuse_many("anna", LIMIT_REFUSALS_AT_ONCE + 2U, NOW_MS);
    refuse_many("anna", 1U, NOW_MS + LIMIT_REFUSAL_PAUSE_MS);
    expect_newest(
        LIMIT_REFUSALS_AT_ONCE + 1U, "anna",
        "(2 before it are not logged) POST /api/v1/targeting/entry {\"id\":1} answered 409 "
        "{\"id\":1,\"state\":\"done\"}");
}

void test_SWR_EVENT_019_who_is_refused_takes_no_room_of_who_commands(void)
{
    refuse_many(NULL, LIMIT_REFUSALS_AT_ONCE + 1U, NOW_MS);
    http_record_entry_t entry = command_of(NULL);
    http_record_write(&record, &entry, NOW_MS);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_REFUSALS_AT_ONCE, exchange_newest_note(server));
    entry.who = "anna";
    http_record_write(&record, &entry, NOW_MS);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_REFUSALS_AT_ONCE + 1U, exchange_newest_note(server));
}

void test_SWR_EVENT_019_commands_have_a_pace_too(void)
{
    const http_record_entry_t entry = command_of("anna");
    for (uint32_t i = 0U; i < (LIMIT_TRANSACTIONS_AT_ONCE + 1U); i++) {
        http_record_write(&record, &entry, NOW_MS);
    }
    TEST_ASSERT_EQUAL_UINT32(LIMIT_TRANSACTIONS_AT_ONCE, exchange_newest_note(server));
    http_record_tick(&record, NOW_MS + LIMIT_TRANSACTION_PAUSE_MS);
    expect_newest(LIMIT_TRANSACTIONS_AT_ONCE + 1U, "http",
                  "1 request, not refused, came too fast to be logged.");
}

void test_SWR_EVENT_019_notes_that_are_behind_are_not_pushed_out(void)
{
    for (uint32_t i = 0U; i <= (LIMIT_NOTES_KEPT / 2U); i++) {
        http_notes_write(&notes, NOTE_LOGIN, "anna", "logged in.");
    }
    const http_record_entry_t entry = command_of("anna");
    http_record_write(&record, &entry, NOW_MS);
    TEST_ASSERT_EQUAL_UINT32((LIMIT_NOTES_KEPT / 2U) + 1U, exchange_newest_note(server));
    TEST_ASSERT_EQUAL_UINT32(1U, record.commanded.left_out);
}

static exchange_peers_t imagers;

static void send_status(uint32_t index, const char *status)
{
    exchange_peer_t *peer = &imagers.peers[index];
    peer->number = 11U + index;
    peer->since_us = 1U;
    (void)snprintf(peer->name, sizeof peer->name, "127.0.0.1:%u", (unsigned)(5000U + index));
    (void)snprintf(peer->status, sizeof peer->status, "%s", status);
    peer->statuses++;
    exchange_publish_peers(server, COMMAND_SOURCE_IGTL, &imagers);
}

static void refuse(uint32_t index, const char *refusal)
{
    exchange_peer_t *peer = &imagers.peers[index];
    (void)snprintf(peer->refusal, sizeof peer->refusal, "%s", refusal);
    peer->refusals++;
    exchange_publish_peers(server, COMMAND_SOURCE_IGTL, &imagers);
}

static void expect_status(uint32_t number, const char *who, const char *sentence)
{
    exchange_note_t note;
    TEST_ASSERT_EQUAL_UINT32(number, exchange_newest_note(server));
    TEST_ASSERT_TRUE(exchange_read_note(control, number, &note));
    TEST_ASSERT_EQUAL_UINT32(NOTE_STATUS, note.kind);
    TEST_ASSERT_EQUAL_STRING(who, note.who);
    TEST_ASSERT_EQUAL_STRING(sentence, note.text);
}

static void begin_imagers(uint32_t count)
{
    (void)memset(&imagers, 0, sizeof imagers);
    imagers.count = count;
}

void test_SWR_EVENT_022_a_status_that_has_changed_is_logged_once(void)
{
    begin_imagers(1U);
    http_peers_log_tick(&statuses, NOW_MS);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_newest_note(server));
    send_status(0U, "IMAGER 1 OK Valid Target");
    http_peers_log_tick(&statuses, NOW_MS);
    http_peers_log_tick(&statuses, NOW_MS + LIMIT_STATUS_LOG_PAUSE_MS);
    expect_status(1U, "127.0.0.1:5000", "STATUS IMAGER 1 OK Valid Target");
}

void test_SWR_EVENT_022_of_many_the_newest_is_logged_with_the_number_of_those_before_it(void)
{
    begin_imagers(1U);
    send_status(0U, "a");
    http_peers_log_tick(&statuses, NOW_MS);
    send_status(0U, "b");
    http_peers_log_tick(&statuses, NOW_MS + LIMIT_STATUS_LOG_PAUSE_MS - 1U);
    send_status(0U, "c");
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_newest_note(server));
    http_peers_log_tick(&statuses, NOW_MS + LIMIT_STATUS_LOG_PAUSE_MS);
    expect_status(2U, "127.0.0.1:5000", "(1 before it are not logged) STATUS c");
}

void test_SWR_EVENT_022_who_changes_all_the_time_does_not_keep_another_from_the_log(void)
{
    begin_imagers(2U);
    send_status(0U, "a");
    send_status(1U, "z");
    http_peers_log_tick(&statuses, NOW_MS);
    send_status(0U, "b");
    http_peers_log_tick(&statuses, NOW_MS + LIMIT_STATUS_LOG_PAUSE_MS);
    expect_status(2U, "127.0.0.1:5001", "STATUS z");
}

void test_SWR_EVENT_022_a_connection_of_another_run_with_the_same_number_is_another(void)
{
    begin_imagers(1U);
    send_status(0U, "a");
    http_peers_log_tick(&statuses, NOW_MS);
    imagers.peers[0].since_us = 2U;
    exchange_publish_peers(server, COMMAND_SOURCE_IGTL, &imagers);
    http_peers_log_tick(&statuses, NOW_MS + LIMIT_STATUS_LOG_PAUSE_MS);
    expect_status(2U, "127.0.0.1:5000", "STATUS a");
}

void test_SWR_EVENT_023_a_refusal_of_igtl_is_logged_beside_the_status(void)
{
    exchange_note_t note;
    begin_imagers(1U);
    send_status(0U, "a");
    refuse(0U, "PROBE WRONG_UNIT: Give the unit.");
    http_peers_log_tick(&statuses, NOW_MS);
    expect_status(1U, "127.0.0.1:5000", "STATUS a");
    http_peers_log_tick(&statuses, NOW_MS + LIMIT_STATUS_LOG_PAUSE_MS);
    TEST_ASSERT_TRUE(exchange_read_note(control, 2U, &note));
    TEST_ASSERT_EQUAL_UINT32(NOTE_REFUSAL, note.kind);
    TEST_ASSERT_EQUAL_STRING("REFUSED PROBE WRONG_UNIT: Give the unit.", note.text);
    http_peers_log_tick(&statuses, NOW_MS + (2U * LIMIT_STATUS_LOG_PAUSE_MS));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_newest_note(server));
}
