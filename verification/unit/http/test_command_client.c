/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: what a page asks for is done once and answered to it, in its name alone, and
 * what it had ends with its session and with its server. */
#include "procedure/command_kinds.h"
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_peers.h"
#include "http/pages/command_client.h"
#include "http/pages/page_table.h"
#include "http/login/account.h"
#include "http/login/session_store.h"
#include "http/login/session_table.h"

#include <stdio.h>
#include <unistd.h>

#define COMMANDS 16U

static exchange_t *control;
static exchange_t *server;
static char name[32];
static char error[256];
static command_client_t client;
static session_store_t sessions;
static const session_t *anna;
static const session_t *bert;
static command_t taken[COMMANDS];
static answer_t answer;

static const account_t account_of_anna = {.name = "anna", .role = ROLE_OPERATOR};
static const account_t account_of_bert = {.name = "bert", .role = ROLE_OPERATOR};
static const command_t go = {.kind = COMMAND_WORKPHASE,
                             .as.workphase = {.workphase = WORKPHASE_START_UP}};
static const command_t plan = {.kind = COMMAND_WORKPHASE,
                               .as.workphase = {.workphase = WORKPHASE_PLANNING}};

static void witness(void *owner, note_kind_t kind, const char *who, const char *text)
{
    (void)owner;
    (void)kind;
    (void)who;
    (void)text;
}

void setUp(void)
{
    (void)snprintf(name, sizeof name, "test-act-client-%d", (int)getpid());
    control = exchange_create(name, 64U, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(control, error);
    server = exchange_open(name, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(server, error);
    session_store_init(&sessions, NULL, witness, NULL);
    anna = session_table_open(&sessions.table, &account_of_anna, 0U);
    bert = session_table_open(&sessions.table, &account_of_bert, 0U);
    command_client_init(&client, server);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, COMMANDS));
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 7U, anna, 0U));
}

void tearDown(void)
{
    exchange_close(server);
    exchange_close(control);
}

static uint32_t take_commands(void)
{
    return exchange_take_commands(control, taken, COMMANDS);
}

/* To the newest command that was taken. */
static void answer_as(answer_kind_t kind, bool is_final)
{
    const answer_t reported = {.id = taken[0].id,
                               .source = COMMAND_SOURCE_HTTP,
                               .command = taken[0].kind,
                               .asked = (uint32_t)command_kinds_workphase(&taken[0]),
                               .kind = (uint32_t)kind,
                               .status = (kind == ANSWER_ABORTED) ? STATUS_DISCARDED : STATUS_OK,
                               .is_final = is_final ? 1U : 0U};
    TEST_ASSERT_TRUE(exchange_push_answer(control, &reported));
}

static act_verdict_t ask(uint32_t page, uint32_t id, const command_t *command)
{
    return command_client_ask(&client, page, id, command, &answer);
}

/* Asks, and control does it. */
static void do_act(uint32_t page, uint32_t id)
{
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(page, id, &plan));
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
    answer_as(ANSWER_ACCEPTED, true);
    TEST_ASSERT_EQUAL(ACT_ANSWERED, command_client_look(&client, page, id, &plan, &answer));
}

void test_SWR_HTTP_021_an_act_is_one_command_in_the_name_of_its_page(void)
{
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 1U, &go));
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
    TEST_ASSERT_EQUAL_UINT32(COMMAND_SOURCE_HTTP, taken[0].source);
    TEST_ASSERT_EQUAL_UINT32(7U, taken[0].peer);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_WORKPHASE, taken[0].kind);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_START_UP, taken[0].as.workphase.workphase);
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, command_client_look(&client, 7U, 1U, &go, &answer));
    answer_as(ANSWER_REFUSED, true);
    TEST_ASSERT_EQUAL(ACT_ANSWERED, command_client_look(&client, 7U, 1U, &go, &answer));
    TEST_ASSERT_EQUAL_UINT32(ANSWER_REFUSED, answer.kind);
}

void test_SWR_HTTP_023_a_repeated_act_does_nothing_and_reports_how_it_stands(void)
{
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 1U, &go));
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 1U, &go));
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
    answer_as(ANSWER_ACCEPTED, false);
    TEST_ASSERT_EQUAL(ACT_ANSWERED, ask(7U, 1U, &go));
    TEST_ASSERT_EQUAL_UINT32(0U, answer.is_final);
    answer_as(ANSWER_DONE, true);
    TEST_ASSERT_EQUAL(ACT_ANSWERED, ask(7U, 1U, &go));
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(0U, take_commands());
}

void test_SWR_HTTP_023_an_id_stands_for_one_act_and_grows(void)
{
    do_act(7U, 5U);
    TEST_ASSERT_EQUAL(ACT_ID_USED, ask(7U, 5U, &go));
    TEST_ASSERT_EQUAL(ACT_ID_USED, ask(7U, 4U, &plan));
    TEST_ASSERT_EQUAL_UINT32(0U, take_commands());
    do_act(7U, UINT32_MAX);
}

/* Otherwise the sender of another target would get the outcome of the one before. */
void test_SWR_HTTP_023_an_id_does_not_stand_for_another_pose_or_way(void)
{
    const command_t target = {.kind = COMMAND_TARGET, .as.pose.pose.translation.x_nm = 1000};
    command_t other = target;
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 1U, &target));
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 1U, &target));
    other.as.pose.pose.translation.x_nm = 1001;
    TEST_ASSERT_EQUAL(ACT_ID_USED, ask(7U, 1U, &other));
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
    const command_t jog = {.kind = COMMAND_JOG, .as.jog = {.axis = 1U, .to_ticks = 100}};
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 2U, &jog));
    other = jog;
    other.as.jog.to_ticks = -100;
    TEST_ASSERT_EQUAL(ACT_ID_USED, ask(7U, 2U, &other));
    other = jog;
    other.as.jog.axis = 2U;
    TEST_ASSERT_EQUAL(ACT_ID_USED, ask(7U, 2U, &other));
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
}

/* Commands of a probe, of positions that are restored, and of axes that run at speeds. */
void test_SWR_HTTP_023_an_id_does_not_stand_for_other_ticks_or_speeds(void)
{
    const uint32_t last = ROBOT_PROBE_LENGTHS - 1U;
    const command_t probe = {.kind = COMMAND_PROBE,
                             .as.probe = {.count = 1U, .lengths_nm = {100, 200}}};
    command_t other = probe;
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 1U, &probe));
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 1U, &probe));
    other.as.probe.lengths_nm[0] = 101;
    TEST_ASSERT_EQUAL(ACT_ID_USED, ask(7U, 1U, &other));
    TEST_ASSERT_EQUAL(ACT_ID_USED, command_client_look(&client, 7U, 1U, &other, &answer));
    other = probe;
    other.as.probe.lengths_nm[last] = 1;
    TEST_ASSERT_EQUAL(ACT_ID_USED, ask(7U, 1U, &other));
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
    const command_t velocity = {.kind = COMMAND_VELOCITY,
                                .as.velocity = {.axes = 1U, .time_ms = 100U}};
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 2U, &velocity));
    other = velocity;
    other.as.velocity.speeds_ticks_per_s[ROBOT_AXIS_MAX - 1U] = -1;
    TEST_ASSERT_EQUAL(ACT_ID_USED, ask(7U, 2U, &other));
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
}

void test_SWR_HTTP_023_what_is_not_kept_any_more_is_refused(void)
{
    for (uint32_t id = 1U; id <= (LIMIT_PAGE_ACTS + 1U); id++) {
        do_act(7U, id);
    }
    TEST_ASSERT_EQUAL(ACT_ID_USED, ask(7U, 1U, &plan));
    TEST_ASSERT_EQUAL(ACT_ANSWERED, ask(7U, 2U, &plan));
    TEST_ASSERT_EQUAL_UINT32(0U, take_commands());
}

void test_SWR_HTTP_023_an_act_that_goes_on_is_kept_before_others(void)
{
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 1U, &go));
    (void)take_commands();
    answer_as(ANSWER_ACCEPTED, false);
    const command_t begun = taken[0];
    for (uint32_t id = 2U; id <= (LIMIT_PAGE_ACTS + 2U); id++) {
        do_act(7U, id);
    }
    taken[0] = begun;
    answer_as(ANSWER_ABORTED, true);
    TEST_ASSERT_EQUAL(ACT_ANSWERED, ask(7U, 1U, &go));
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
}

void test_SWR_HTTP_023_what_was_not_sent_has_not_used_its_id(void)
{
    for (uint32_t id = 1U; id <= EXCHANGE_COMMANDS; id++) {
        TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, id, &plan));
    }
    TEST_ASSERT_EQUAL(ACT_LATER, ask(7U, 90U, &plan));
    TEST_ASSERT_FALSE(command_client_send(&client, 7U, &plan));
    TEST_ASSERT_EQUAL_UINT32(COMMANDS, take_commands());
    do_act(7U, 90U);
}

void test_SWR_HTTP_028_the_end_of_an_act_is_news(void)
{
    act_result_t news;
    uint32_t next = command_client_result_count(&client);
    do_act(7U, 1U);
    TEST_ASSERT_FALSE(command_client_read_results(&client, &next, &news));
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 2U, &go));
    (void)take_commands();
    answer_as(ANSWER_ACCEPTED, false);
    answer_as(ANSWER_DONE, true);
    command_client_tick(&client, &sessions, 0U);
    TEST_ASSERT_TRUE(command_client_read_results(&client, &next, &news));
    TEST_ASSERT_EQUAL_UINT32(7U, news.page);
    TEST_ASSERT_EQUAL_UINT32(2U, news.id);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, news.answer.kind);
    TEST_ASSERT_FALSE(command_client_read_results(&client, &next, &news));
}

void test_SWR_HTTP_028_who_reads_slowly_gets_the_newest(void)
{
    act_result_t news;
    uint32_t next = 0U;
    for (uint32_t id = 1U; id <= (COMMAND_CLIENT_RESULT_COUNT + 3U); id++) {
        TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, id, &go));
        (void)take_commands();
        answer_as(ANSWER_ACCEPTED, false);
        answer_as(ANSWER_DONE, true);
    }
    command_client_tick(&client, &sessions, 0U);
    TEST_ASSERT_TRUE(command_client_read_results(&client, &next, &news));
    TEST_ASSERT_EQUAL_UINT32(4U, news.id);
}

void test_SWR_HTTP_022_the_page_of_another_session_is_refused(void)
{
    TEST_ASSERT_EQUAL(PAGE_ANOTHERS, command_client_register_page(&client, 7U, bert, 0U));
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 8U, bert, 0U));
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 7U, anna, 0U));
}

void test_SWR_HTTP_022_a_session_has_few_pages_and_keeps_the_one_with_authority(void)
{
    do_act(7U, 3U);
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 50U, bert, 7U));
    for (uint32_t page = 100U; page < (100U + (3U * LIMIT_SESSION_PAGES)); page++) {
        TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, page, anna, 7U));
    }
    TEST_ASSERT_EQUAL(ACT_ANSWERED, ask(7U, 3U, &plan));
    TEST_ASSERT_NOT_NULL(page_table_find(&client.table, 50U));
    TEST_ASSERT_NULL(page_table_find(&client.table, 100U));
    TEST_ASSERT_EQUAL(ACT_LATER, ask(100U, 1U, &plan));
    TEST_ASSERT_EQUAL(PAGE_ANOTHERS, command_client_register_page(&client, 7U, bert, 7U));
}

/* It may have asked for the button: what is granted then must not be another session's. */
void test_SWR_HTTP_022_what_a_forgotten_page_has_is_released_first(void)
{
    for (uint32_t page = 1U; page < LIMIT_SESSION_PAGES; page++) {
        TEST_ASSERT_EQUAL(PAGE_GREETED,
                          command_client_register_page(&client, 100U + page, anna, 0U));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, take_commands());
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 200U, anna, 0U));
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
    TEST_ASSERT_EQUAL_UINT32(COMMAND_RELEASE, taken[0].kind);
    TEST_ASSERT_EQUAL_UINT32(7U, taken[0].peer);
    while (command_client_send(&client, 200U, &plan)) {
    }
    TEST_ASSERT_EQUAL(PAGE_LATER, command_client_register_page(&client, 201U, anna, 0U));
    TEST_ASSERT_NOT_NULL(page_table_find(&client.table, 101U));
}

void test_SWR_HTTP_022_the_page_that_goes_is_the_one_that_asked_for_nothing_longest(void)
{
    for (uint32_t page = 100U; page < (99U + LIMIT_SESSION_PAGES); page++) {
        TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, page, anna, 0U));
    }
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 7U, anna, 0U));
    TEST_ASSERT_EQUAL(PAGE_ANOTHERS, command_client_register_page(&client, 100U, bert, 0U));
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 200U, anna, 0U));
    TEST_ASSERT_NOT_NULL(page_table_find(&client.table, 7U));
    TEST_ASSERT_NULL(page_table_find(&client.table, 100U));
}

void test_SWR_HTTP_034_who_its_pages_are_is_published(void)
{
    char title[EXCHANGE_TITLE_SIZE];
    exchange_peers_t peers;
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 8U, bert, 0U));
    exchange_title(control, COMMAND_SOURCE_HTTP, 8U, title);
    TEST_ASSERT_EQUAL_STRING("page of bert", title);
    session_store_log_out(&sessions, anna->id, 0U);
    command_client_tick(&client, &sessions, 0U);
    TEST_ASSERT_TRUE(exchange_read_peers(control, COMMAND_SOURCE_HTTP, &peers));
    TEST_ASSERT_EQUAL_UINT32(1U, peers.count);
    TEST_ASSERT_EQUAL_UINT32(8U, peers.peers[0].number);
    TEST_ASSERT_TRUE(peers.peers[0].since_us > 0U);
}

void test_SWR_HTTP_024_an_earlier_server_is_released_before_anything_is_sent(void)
{
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(7U, 1U, &go));
    (void)take_commands();
    answer_as(ANSWER_ACCEPTED, true);
    while (command_client_send(&client, 7U, &plan)) {
    }
    command_client_init(&client, server);
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 9U, anna, 0U));
    TEST_ASSERT_EQUAL_UINT32(COMMANDS, take_commands());
    TEST_ASSERT_EQUAL(ACT_LATER, ask(9U, 1U, &go));
    TEST_ASSERT_FALSE(command_client_send(&client, 9U, &go));
    command_client_tick(&client, &sessions, 0U);
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(9U, 1U, &go));
    TEST_ASSERT_EQUAL_UINT32(2U, take_commands());
    TEST_ASSERT_EQUAL_UINT32(COMMAND_RELEASE, taken[0].kind);
    TEST_ASSERT_EQUAL_UINT32(0U, taken[0].peer);
    TEST_ASSERT_EQUAL_UINT32(9U, taken[1].peer);
}

void test_SWR_HTTP_025_what_a_page_has_ends_with_its_session(void)
{
    TEST_ASSERT_EQUAL(PAGE_GREETED, command_client_register_page(&client, 8U, bert, 0U));
    command_client_tick(&client, &sessions, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, take_commands());
    session_store_log_out(&sessions, anna->id, 0U);
    command_client_tick(&client, &sessions, 0U);
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
    TEST_ASSERT_EQUAL_UINT32(COMMAND_RELEASE, taken[0].kind);
    TEST_ASSERT_EQUAL_UINT32(7U, taken[0].peer);
    TEST_ASSERT_EQUAL(ACT_LATER, ask(7U, 1U, &go));
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER, ask(8U, 1U, &go));
}

void test_SWR_HTTP_025_a_full_lane_only_delays_it(void)
{
    while (command_client_send(&client, 7U, &plan)) {
    }
    session_store_log_out(&sessions, anna->id, 0U);
    command_client_tick(&client, &sessions, 0U);
    (void)take_commands();
    command_client_tick(&client, &sessions, 0U);
    TEST_ASSERT_EQUAL_UINT32(1U, take_commands());
    TEST_ASSERT_EQUAL_UINT32(COMMAND_RELEASE, taken[0].kind);
}

/* None of more than have room is waited for. */
void test_SWR_TRAJ_021_rows_are_sent_some_at_once_and_refused_where_there_is_no_room(void)
{
    static const command_t rows[COMMAND_CLIENT_BATCH];
    static answer_t answers[COMMAND_CLIENT_BATCH];
    const command_t row = {.kind = (uint32_t)COMMAND_NOTE};

    for (uint32_t i = 0U; i < (EXCHANGE_COMMANDS - COMMAND_CLIENT_BATCH + 1U); i++) {
        TEST_ASSERT_TRUE(command_client_send(&client, 7U, &row));
    }
    TEST_ASSERT_EQUAL(ACT_LATER,
                      command_client_do_all(&client, 7U, rows, COMMAND_CLIENT_BATCH, answers));
    TEST_ASSERT_EQUAL_UINT32(0U, client.batch_count);
    while (take_commands() > 0U) {
    }
    TEST_ASSERT_EQUAL(ACT_NO_ANSWER,
                      command_client_do_all(&client, 7U, rows, COMMAND_CLIENT_BATCH, answers));
    TEST_ASSERT_EQUAL_UINT32(0U, client.batch_count);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_CLIENT_BATCH, take_commands());
}
