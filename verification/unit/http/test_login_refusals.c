/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: failed logins make the next ones of their origin wait, without locking out a
 * user who has the password or the code, and are logged without a flood of lines. */
#include "unity.h"

#include "http/login/device_mark.h"
#include "http/login/login_delay.h"
#include "http/login/session_store.h"
#include "unit/support/session_world.inc"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

void setUp(void)
{
    begin_sessions();
}

void tearDown(void)
{
    (void)unlink(file);
}

/* From somewhere, with what the browser says of itself. */
static login_verdict_t enter_from(const char *name, const char *password, const char *address,
                                  const char *mark)
{
    const login_t login = {.name = name, .password = password, .address = address, .mark = mark};
    return session_store_log_in(&store, &login, now_ms, &session, &wait_s);
}

/* Until logins of that name from there are not judged. */
static void guess(const char *name, const char *address)
{
    while (enter_from(name, "wrong", address, NULL) != LOGIN_LATER) {
    }
}

static const login_name_t her_name = {.name = "anna", .is_known = true};
static const login_name_t his_name = {.name = "bert", .is_known = true};

void test_SWR_SESS_014_who_comes_with_an_earlier_time_waits_all_the_same(void)
{
    login_delay_t delay = {.invented_in_all = {.failures = 0U}};
    for (unsigned i = 0U; i <= LIMIT_LOGIN_FREE_FAILURES; i++) {
        login_delay_note(&delay, her_name, false, now_ms - i);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, login_delay_left_s(&delay, her_name, now_ms - 10U));
}

void test_SWR_SESS_014_guessing_one_account_doubles_the_wait_up_to_the_most(void)
{
    static const uint32_t waits[] = {0U, 0U, 0U, 0U, 1U, 2U, 4U, 8U, 16U, 32U, 64U, 64U, 64U};
    login_delay_t delay = {.invented_in_all = {.failures = 0U}};
    for (size_t i = 0U; i < (sizeof waits / sizeof waits[0]); i++) {
        TEST_ASSERT_EQUAL_UINT32(waits[i], login_delay_left_s(&delay, her_name, now_ms));
        now_ms += (uint64_t)waits[i] * SECOND;
        TEST_ASSERT_EQUAL_UINT32(0U, login_delay_left_s(&delay, her_name, now_ms));
        login_delay_note(&delay, her_name, false, now_ms);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, login_delay_left_s(&delay, his_name, now_ms));
    login_delay_note(&delay, her_name, true, now_ms);
    TEST_ASSERT_EQUAL_UINT32(0U, login_delay_left_s(&delay, her_name, now_ms));
}

static const login_name_t zoe = {.name = "zoe", .is_known = false};

void test_SWR_SESS_014_inventing_many_names_makes_invented_ones_wait(void)
{
    login_delay_t delay = {.invented_in_all = {.failures = 0U}};
    for (unsigned i = 0U; i < LIMIT_LOGIN_FREE_FAILURES_IN_ALL; i++) {
        char name[8];
        (void)snprintf(name, sizeof name, "a%u", i);
        const login_name_t other = {.name = name, .is_known = false};
        TEST_ASSERT_EQUAL_UINT32(0U, login_delay_left_s(&delay, zoe, now_ms));
        login_delay_note(&delay, other, false, now_ms);
    }
    const login_name_t last = {.name = "x", .is_known = false};
    login_delay_note(&delay, last, false, now_ms);
    TEST_ASSERT_EQUAL_UINT32(1U, login_delay_left_s(&delay, zoe, now_ms));
    now_ms += LIMIT_LOGIN_FORGET_S * SECOND;
    login_delay_note(&delay, last, false, now_ms);
    TEST_ASSERT_EQUAL_UINT32(0U, login_delay_left_s(&delay, zoe, now_ms));
}

/* Any of them, so also those that fall into her row. */
void test_SWR_SESS_028_no_invented_name_makes_an_account_wait(void)
{
    login_delay_t delay = {.invented_in_all = {.failures = 0U}};
    for (unsigned i = 0U; i < (100U * LOGIN_DELAY_ROWS); i++) {
        char name[8];
        (void)snprintf(name, sizeof name, "b%u", i);
        const login_name_t other = {.name = name, .is_known = false};
        login_delay_note(&delay, other, false, now_ms);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, login_delay_left_s(&delay, her_name, now_ms));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_LOGIN_DELAY_MOST_S, login_delay_left_s(&delay, zoe, now_ms));
}

void test_SWR_SESS_028_an_account_logs_in_after_a_flood_of_invented_names(void)
{
    for (unsigned i = 0U; i < (2U * LIMIT_LOGIN_FREE_FAILURES_IN_ALL); i++) {
        char name[8];
        (void)snprintf(name, sizeof name, "c%u", i);
        (void)enter(name, "wrong");
    }
    TEST_ASSERT_EQUAL_INT(LOGIN_LATER, enter("zoe", "wrong"));
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
}

void test_SWR_SESS_014_it_never_overflows(void)
{
    login_delay_t delay = {.invented_in_all = {.failures = UINT32_MAX - 1U, .failed_ms = now_ms}};
    TEST_ASSERT_EQUAL_UINT32(LIMIT_LOGIN_DELAY_MOST_S, login_delay_left_s(&delay, zoe, now_ms));
}

void test_SWR_SESS_014_names_that_do_not_exist_wait_like_those_that_do(void)
{
    static const char *const names[] = {"anna", "nobody"};
    uint32_t waits[2][5];
    for (size_t k = 0U; k < 2U; k++) {
        for (size_t i = 0U; i < 5U; i++) {
            waits[k][i] = (enter(names[k], "wrong") == LOGIN_LATER) ? wait_s : 0U;
        }
    }
    TEST_ASSERT_EQUAL_UINT32_ARRAY(waits[0], waits[1], 5U);
    TEST_ASSERT_EQUAL_UINT32(1U, waits[0][4]);
}

void test_SWR_SESS_014_the_right_password_is_not_looked_at_too_soon(void)
{
    for (unsigned i = 0U; i <= LIMIT_LOGIN_FREE_FAILURES; i++) {
        TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("anna", "wrong"));
    }
    TEST_ASSERT_EQUAL_INT(LOGIN_LATER, enter("anna", "correct horse"));
    now_ms += SECOND;
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
}

void test_SWR_SESS_031_guessing_elsewhere_does_not_keep_the_right_password_waiting(void)
{
    guess("anna", "10.0.0.7");
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter_from("anna", "correct horse", "10.0.0.8", NULL));
    TEST_ASSERT_EQUAL_INT(LOGIN_LATER, enter_from("anna", "correct horse", "10.0.0.7", NULL));
}

void test_SWR_SESS_032_a_browser_that_has_logged_in_before_does_not_wait_for_guesses(void)
{
    char mark[DEVICE_MARK_SIZE];
    TEST_ASSERT_TRUE(session_store_write_mark(&store, "anna", mark));
    guess("anna", "127.0.0.1");
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter_from("anna", "correct horse", "127.0.0.1", mark));
    TEST_ASSERT_EQUAL_INT(LOGIN_LATER, enter_from("anna", "correct horse", "127.0.0.1", NULL));
}

void test_SWR_SESS_032_marked_browsers_that_guess_wait_as_well_and_keep_no_stranger_out(void)
{
    char mark[DEVICE_MARK_SIZE];
    TEST_ASSERT_TRUE(session_store_write_mark(&store, "anna", mark));
    for (unsigned i = 0U; i <= LIMIT_LOGIN_FREE_FAILURES; i++) {
        TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_from("anna", "wrong", "127.0.0.1", mark));
    }
    TEST_ASSERT_EQUAL_INT(LOGIN_LATER, enter_from("anna", "correct horse", "127.0.0.1", mark));
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter_from("anna", "correct horse", "127.0.0.1", NULL));
}

void test_SWR_SESS_032_a_mark_is_good_for_its_name_and_its_process_alone(void)
{
    static session_store_t other;
    char hers[DEVICE_MARK_SIZE];
    char his[DEVICE_MARK_SIZE];
    char old[DEVICE_MARK_SIZE];
    session_store_init(&other, file, witness, said);
    TEST_ASSERT_TRUE(session_store_write_mark(&store, "anna", hers));
    TEST_ASSERT_TRUE(session_store_write_mark(&store, "bert", his));
    TEST_ASSERT_TRUE(session_store_write_mark(&other, "anna", old));
    TEST_ASSERT_EQUAL_UINT(DEVICE_MARK_SIZE - 1U, strlen(hers));
    guess("anna", "127.0.0.1");
    TEST_ASSERT_EQUAL_INT(LOGIN_LATER, enter_from("anna", "correct horse", "127.0.0.1", his));
    TEST_ASSERT_EQUAL_INT(LOGIN_LATER, enter_from("anna", "correct horse", "127.0.0.1", old));
    TEST_ASSERT_EQUAL_INT(LOGIN_LATER, enter_from("anna", "correct horse", "127.0.0.1", ""));
    hers[0] = (hers[0] == '0') ? '1' : '0';
    TEST_ASSERT_EQUAL_INT(LOGIN_LATER, enter_from("anna", "correct horse", "127.0.0.1", hers));
}

void test_SWR_SESS_032_without_a_key_there_is_no_mark(void)
{
    static const device_key_t none;
    char mark[DEVICE_MARK_SIZE] = "";
    TEST_ASSERT_FALSE(device_mark_make(&none, "anna", mark));
    TEST_ASSERT_FALSE(device_mark_fits(&none, "anna", mark));
}

void test_SWR_SESS_034_wrong_codes_do_not_keep_the_right_one_waiting(void)
{
    session_store_init(&store, NULL, witness, said);
    TEST_ASSERT_TRUE(session_store_make_code(&store));
    for (unsigned i = 0U; i < (10U * LIMIT_LOGIN_FREE_FAILURES); i++) {
        TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_by_code("ABCD-EFGH-2345"));
    }
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter_by_code(store.code));
}

void test_SWR_SESS_020_what_a_stranger_calls_himself_is_not_written(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("a\nroot logged in as service", "x"));
    TEST_ASSERT_EQUAL_STRING("1 ?: login refused: name, password or code is wrong.\n", said);
}

void test_SWR_SESS_021_refusals_within_a_second_are_reported_with_the_next(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("anna", "wrong"));
    now_ms += SECOND - 1U;
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("bert", "wrong"));
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("carl", "wrong"));
    TEST_ASSERT_EQUAL_UINT(1U, count_said("refused"));
    now_ms++;
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("dora", "wrong"));
    TEST_ASSERT_EQUAL_STRING("1 anna: login refused: name, password or code is wrong.\n"
                             "1 dora: login refused: name, password or code is wrong. Refused "
                             "before it without a line, of any name: 2.\n",
                             said);
}

void test_SWR_SESS_322_a_count_of_refusals_is_ascribed_to_no_name(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("anna", "wrong"));
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("bert", "wrong"));
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("carl", "wrong"));
    said[0] = '\0';
    session_store_tick(&store, now_ms + (LIMIT_REFUSALS_LINE_S * SECOND));
    TEST_ASSERT_EQUAL_STRING("1 http: logins refused that came too soon to be judged or logged, of "
                             "any name: 2; the last of carl.\n",
                             said);
}

void test_SWR_SESS_322_the_longest_address_cuts_neither_cause_nor_count(void)
{
    static const char address[] = "plain 2001:0db8:0000:0000:0000:ff00:0042:8329:8443";
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_from("anna", "wrong", address, NULL));
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_from("bert", "wrong", address, NULL));
    now_ms += SECOND;
    said[0] = '\0';
    const login_t login = {.name = "carl", .password = "secret", .address = address};
    static const char cause[] = "a listener in the clear takes no login unless it is that of the "
                                "loopback address, which this one is not.";
    now_ms += LIMIT_REFUSALS_LINE_S * SECOND;
    session_store_note_refusal(&store, &login, cause, now_ms);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, address), said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, cause), said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, "of any name: 1.\n"), said);
}

void test_SWR_SESS_021_a_flood_that_is_not_looked_at_is_a_line_now_and_then(void)
{
    const uint64_t begin_ms = now_ms;
    for (unsigned i = 0U; i <= LIMIT_LOGIN_FREE_FAILURES; i++) {
        TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("anna", "wrong"));
    }
    said[0] = '\0';
    store.is_looking = true;
    for (; now_ms < (begin_ms + (LIMIT_REFUSALS_LINE_S * SECOND)); now_ms += 10U) {
        TEST_ASSERT_NOT_EQUAL_INT(LOGIN_REFUSED, enter("anna", "wrong"));
    }
    TEST_ASSERT_EQUAL_STRING("", said);
    session_store_tick(&store, now_ms);
    session_store_tick(&store, now_ms + SECOND);
    char line[160];
    (void)snprintf(line, sizeof line,
                   "1 http: logins refused that came too soon to be judged or logged, of any name: "
                   "%u; the last of anna.\n",
                   (unsigned)(LIMIT_LOGIN_FREE_FAILURES + (LIMIT_REFUSALS_LINE_S * 100U)));
    TEST_ASSERT_EQUAL_STRING(line, said);
}

void test_SWR_SESS_300_a_refusal_names_the_address_and_no_part_of_the_password(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_from("anna", "secret", "TLS 10.0.0.5", NULL));
    TEST_ASSERT_EQUAL_STRING(
        "1 anna: login refused from TLS 10.0.0.5: name, password or code is wrong.\n", said);
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_from("bert", "secret", "TLS 10.0.0.6", NULL));
    now_ms += SECOND;
    said[0] = '\0';
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_from("a b", "secret", "TLS 10.0.0.7", NULL));
    TEST_ASSERT_EQUAL_STRING("1 ?: login refused from TLS 10.0.0.7: name, password or code is "
                             "wrong. Refused before it without a line, of any name: 1.\n",
                             said);
    said[0] = '\0';
    guess("anna", "TLS 10.0.0.8");
    now_ms += LIMIT_REFUSALS_LINE_S * SECOND;
    session_store_tick(&store, now_ms);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, "the last of anna from TLS 10.0.0.8."), said);
}

void test_SWR_SESS_300_a_login_that_is_not_judged_is_logged_as_well(void)
{
    const login_t login = {.name = "anna", .password = "secret", .address = "plain 10.0.0.9"};
    session_store_note_refusal(&store, &login, "not here.", now_ms);
    TEST_ASSERT_EQUAL_STRING("1 anna: login refused from plain 10.0.0.9: not here.\n", said);
    for (unsigned i = 1U; i < (LIMIT_REFUSALS_LINE_S / 2U); i++) {
        session_store_note_refusal(&store, &login, "not here.", now_ms + (i * 2U * SECOND));
    }
    TEST_ASSERT_EQUAL_UINT(1U, count_said("refused"));
}
