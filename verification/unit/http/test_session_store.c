/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a user with the password gets a session that no other can guess or keep, and
 * guessing gets slower. */
#include "unity.h"

#include "http/login/account.h"
#include "http/login/device_mark.h"
#include "http/login/login_delay.h"
#include "http/login/password.h"
#include "http/login/session_store.h"
#include "http/login/session_table.h"

#include <crypt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SECOND UINT64_C(1000)
#define IDLE_MS (LIMIT_SESSION_IDLE_S * SECOND)
#define MOST_MS (LIMIT_SESSION_MOST_S * SECOND)

static char file[] = "/tmp/accounts-XXXXXX";
static char said[4096];
static session_store_t store;
static session_t session;
static uint32_t wait_s;
static uint64_t now_ms;

static void witness(void *owner, note_kind_t kind, const char *who, const char *text)
{
    TEST_ASSERT_EQUAL_PTR(said, owner);
    (void)snprintf(&said[strlen(said)], sizeof said - strlen(said), "%u %s: %s\n", (unsigned)kind,
                   who, text);
}

/* How often something was said. */
static unsigned count_said(const char *what)
{
    unsigned count = 0U;
    for (const char *place = strstr(said, what); place != NULL; place = strstr(&place[1], what)) {
        count++;
    }
    return count;
}

/* The hash of her password that costs least: most of these tests log in many times. */
static void hash_quickly(char *hash, size_t hash_size)
{
    static struct crypt_data room;
    char setting[CRYPT_GENSALT_OUTPUT_SIZE];
    TEST_ASSERT_NOT_NULL(crypt_gensalt_rn("$y$", 1U, NULL, 0, setting, (int)sizeof setting));
    (void)snprintf(hash, hash_size, "%s",
                   crypt_rn("correct horse", setting, &room, (int)sizeof room));
    TEST_ASSERT_TRUE(password_matches("correct horse", hash));
}

void setUp(void)
{
    static accounts_t accounts;
    static char error[200];
    if (accounts_find(&accounts, "anna") == NULL) {
        account_t anna = {.name = "anna", .role = ROLE_OPERATOR};
        hash_quickly(anna.hash, sizeof anna.hash);
        TEST_ASSERT_TRUE(accounts_put(&accounts, &anna));
    }
    (void)memcpy(&file[sizeof file - 7U], "XXXXXX", 6U);
    TEST_ASSERT_NOT_EQUAL(-1, close(mkstemp(file)));
    TEST_ASSERT_TRUE(accounts_write(&accounts, file, error, sizeof error));
    session_store_init(&store, file, witness, said);
    said[0] = '\0';
    now_ms = 1000000U;
}

void tearDown(void)
{
    (void)unlink(file);
}

static void write_accounts(const accounts_t *accounts)
{
    static char error[200];
    TEST_ASSERT_TRUE_MESSAGE(accounts_write(accounts, file, error, sizeof error), error);
}

static login_verdict_t enter(const char *name, const char *password)
{
    const login_t login = {.name = name, .password = password};
    return session_store_log_in(&store, &login, now_ms, &session, &wait_s);
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

static login_verdict_t enter_by_code(const char *code)
{
    const login_t login = {.code = code};
    return session_store_log_in(&store, &login, now_ms, &session, &wait_s);
}

static bool is_live(void)
{
    session_t found;
    return session_store_find(&store, session.id, now_ms, &found);
}

void test_SWR_SESS_003_a_password_is_kept_as_a_hash_with_a_salt_of_its_own(void)
{
    char one[ACCOUNT_HASH_SIZE];
    char other[ACCOUNT_HASH_SIZE];
    TEST_ASSERT_TRUE(password_hash("correct horse", one, sizeof one));
    TEST_ASSERT_TRUE(password_hash("correct horse", other, sizeof other));
    TEST_ASSERT_EQUAL_STRING_LEN("$y$", one, 3U);
    TEST_ASSERT_NOT_EQUAL(0, strcmp(one, other));
    TEST_ASSERT_TRUE(password_matches("correct horse", one));
    TEST_ASSERT_FALSE(password_matches("correct hors", one));
    TEST_ASSERT_FALSE(password_matches("", one));
    TEST_ASSERT_FALSE(password_matches("correct horse", "$y$broken"));
    TEST_ASSERT_FALSE(password_matches("correct horse", NULL));
}

void test_SWR_SESS_003_nobodys_hash_takes_as_long_as_any(void)
{
    /* libcrypt answers a setting that it cannot read at once, with an error. */
    char hash[4] = "";
    TEST_ASSERT_FALSE(password_hash("x", hash, sizeof hash));
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("nobody", "correct horse"));
}

void test_SWR_SESS_003_one_password_at_a_time_is_looked_at(void)
{
    store.is_looking = true;
    TEST_ASSERT_EQUAL_INT(LOGIN_BUSY, enter("anna", "correct horse"));
    TEST_ASSERT_EQUAL_UINT32(1U, wait_s);
    store.is_looking = false;
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    TEST_ASSERT_FALSE(store.is_looking);
}

void test_SWR_SESS_001_who_was_removed_logs_in_no_more(void)
{
    static const accounts_t nobody;
    static char error[200];
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    TEST_ASSERT_TRUE(accounts_write(&nobody, file, error, sizeof error));
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("anna", "correct horse"));
    (void)unlink(file);
    now_ms += SECOND;
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("anna", "correct horse"));
    TEST_ASSERT_NOT_NULL(strstr(said, "cannot be read"));
}

void test_SWR_SESS_005_the_code_opens_one_session_of_an_engineer(void)
{
    char code[SESSION_CODE_SIZE];
    session_store_init(&store, NULL, witness, said);
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_by_code(""));
    TEST_ASSERT_TRUE(session_store_make_code(&store));
    (void)memcpy(code, store.code, sizeof code);
    TEST_ASSERT_EQUAL_UINT(14U, strlen(code));
    TEST_ASSERT_EQUAL_CHAR('-', code[4]);
    code[13] = (code[13] == 'A') ? 'B' : 'A';
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_by_code(code));
    (void)memcpy(code, store.code, sizeof code);
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter_by_code(code));
    TEST_ASSERT_EQUAL_INT(ROLE_ENGINEER, session.account.role);
    TEST_ASSERT_EQUAL_STRING("code", session.account.name);
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_by_code(code));
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter_by_code(""));
    TEST_ASSERT_EQUAL_INT(LOGIN_REFUSED, enter("anna", "correct horse"));
}

void test_SWR_SESS_007_further_logins_are_refused_until_a_session_ends(void)
{
    store.compared_ms = now_ms;
    account_t other = {.name = "0", .role = ROLE_OPERATOR};
    for (unsigned i = 0U; i < LIMIT_SESSIONS; i++) {
        other.name[0]++;
        TEST_ASSERT_NOT_NULL(session_table_open(&store.table, &other, now_ms));
    }
    const session_t first = store.table.sessions[0];
    session = store.table.sessions[1];
    TEST_ASSERT_EQUAL_INT(LOGIN_FULL, enter("anna", "correct horse"));
    TEST_ASSERT_TRUE(is_live());
    session_store_log_out(&store, first.id, now_ms);
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    now_ms += IDLE_MS;
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
}

void test_SWR_SESS_027_one_account_takes_no_more_than_its_share(void)
{
    TEST_ASSERT_LESS_THAN_UINT(LIMIT_SESSIONS, LIMIT_ACCOUNT_SESSIONS);
    for (unsigned i = 0U; i < LIMIT_ACCOUNT_SESSIONS; i++) {
        TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    }
    TEST_ASSERT_EQUAL_INT(LOGIN_FULL, enter("anna", "correct horse"));
    TEST_ASSERT_TRUE(is_live());
    const account_t other = {.name = "ann", .role = ROLE_OPERATOR};
    TEST_ASSERT_NOT_NULL(session_table_open(&store.table, &other, now_ms));
    session_store_log_out(&store, session.id, now_ms);
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
}

static void fill_share(void)
{
    for (unsigned i = 0U; i < LIMIT_ACCOUNT_SESSIONS; i++) {
        TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
        now_ms += SECOND;
    }
}

static bool is_open(const session_t *of)
{
    session_t found;
    return session_store_find(&store, of->id, now_ms, &found);
}

void test_SWR_SESS_029_of_the_sessions_that_were_left_the_oldest_gives_way(void)
{
    fill_share();
    const session_t first = store.table.sessions[0];
    const session_t second = store.table.sessions[1];
    now_ms = first.opened_ms + (LIMIT_SESSION_LEFT_S * SECOND) - 1U;
    TEST_ASSERT_EQUAL_INT(LOGIN_FULL, enter("anna", "correct horse"));
    now_ms = store.table.sessions[3].opened_ms + (LIMIT_SESSION_LEFT_S * SECOND);
    said[0] = '\0';
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    TEST_ASSERT_FALSE(is_open(&first));
    TEST_ASSERT_TRUE(is_open(&second));
    TEST_ASSERT_EQUAL_UINT(1U, count_said("session ended: another login took its place."));
}

void test_SWR_SESS_029_what_is_written_renewed_or_kept_is_not_left(void)
{
    static const session_use_t uses[] = {SESSION_ACTS, SESSION_RUNS};
    for (unsigned i = 0U; i < 2U; i++) {
        fill_share();
        const session_t first = store.table.sessions[0];
        const session_t second = store.table.sessions[1];
        now_ms += LIMIT_SESSION_LEFT_S * SECOND;
        TEST_ASSERT_EQUAL_INT(SESSION_PASS, session_store_judge(&store, first.id, first.csrf,
                                                                uses[i], ROLE_OBSERVER, now_ms));
        TEST_ASSERT_EQUAL_INT(
            SESSION_PASS,
            session_store_judge(&store, second.id, NULL, SESSION_READS, ROLE_OBSERVER, now_ms));
        TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
        TEST_ASSERT_TRUE(is_open(&first));
        TEST_ASSERT_FALSE(is_open(&second));
        (void)memset(&store.table, 0, sizeof store.table);
    }
}

void test_SWR_SESS_029_nobody_elses_gives_way(void)
{
    account_t other = {.name = "0", .role = ROLE_OPERATOR};
    for (unsigned i = 0U; i < LIMIT_SESSIONS; i++) {
        other.name[0]++;
        TEST_ASSERT_NOT_NULL(session_table_open(&store.table, &other, now_ms));
    }
    now_ms += LIMIT_SESSION_LEFT_S * SECOND;
    store.compared_ms = now_ms;
    TEST_ASSERT_EQUAL_INT(LOGIN_FULL, enter("anna", "correct horse"));
}

void test_SWR_SESS_030_who_is_refused_keeps_the_session(void)
{
    const account_t other = {.name = "olga", .role = ROLE_OBSERVER};
    fill_share();
    store.compared_ms = now_ms;
    const session_t had = *session_table_open(&store.table, &other, now_ms);
    const login_t login = {.name = "anna", .password = "correct horse", .id = had.id};
    said[0] = '\0';
    TEST_ASSERT_EQUAL_INT(LOGIN_FULL,
                          session_store_log_in(&store, &login, now_ms, &session, &wait_s));
    TEST_ASSERT_TRUE(is_open(&had));
    TEST_ASSERT_EQUAL_UINT(0U, count_said("session ended"));
}

void test_SWR_SESS_030_both_that_give_way_to_a_login_are_informed(void)
{
    const account_t other = {.name = "olga", .role = ROLE_OBSERVER};
    fill_share();
    now_ms += LIMIT_SESSION_LEFT_S * SECOND;
    store.compared_ms = now_ms;
    const session_t had = *session_table_open(&store.table, &other, now_ms);
    const login_t login = {.name = "anna", .password = "correct horse", .id = had.id};
    said[0] = '\0';
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED,
                          session_store_log_in(&store, &login, now_ms, &session, &wait_s));
    TEST_ASSERT_FALSE(is_open(&had));
    TEST_ASSERT_TRUE(is_open(&session));
    TEST_ASSERT_EQUAL_UINT(2U, count_said("session ended: another login took its place."));
}

void test_SWR_SESS_008_a_login_gets_a_new_identifier_and_ends_the_old_session(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    const session_t old = session;
    const login_t login = {.name = "anna", .password = "correct horse", .id = old.id};
    session_t found;
    TEST_ASSERT_EQUAL_UINT(2U * LIMIT_SESSION_ID_BYTES, strlen(old.id));
    TEST_ASSERT_EQUAL_UINT(2U * LIMIT_SESSION_ID_BYTES, strlen(old.csrf));
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED,
                          session_store_log_in(&store, &login, now_ms, &session, &wait_s));
    TEST_ASSERT_NOT_EQUAL(0, strcmp(old.id, session.id));
    TEST_ASSERT_NOT_EQUAL(0, strcmp(old.csrf, session.csrf));
    TEST_ASSERT_FALSE(session_store_find(&store, old.id, now_ms, &found));
    TEST_ASSERT_EQUAL_UINT(1U, count_said("3 anna: session ended: another login took its place."));
}

void test_SWR_SESS_008_an_identifier_that_the_client_brings_is_never_taken(void)
{
    const login_t login = {.name = "anna", .password = "correct horse", .id = "0123456789abcdef"};
    session_t found;
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED,
                          session_store_log_in(&store, &login, now_ms, &session, &wait_s));
    TEST_ASSERT_FALSE(session_store_find(&store, login.id, now_ms, &found));
}

void test_SWR_SESS_008_only_the_whole_identifier_counts(void)
{
    session_t found;
    char id[SESSION_TOKEN_SIZE + 1U];
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    TEST_ASSERT_FALSE(session_store_find(&store, "", now_ms, &found));
    TEST_ASSERT_FALSE(session_store_find(&store, NULL, now_ms, &found));
    for (size_t i = 0U; i < (SESSION_TOKEN_SIZE - 1U); i++) {
        (void)snprintf(id, sizeof id, "%s", session.id);
        id[i] = (id[i] == '0') ? '1' : '0';
        TEST_ASSERT_FALSE(session_store_find(&store, id, now_ms, &found));
        id[i] = '\0';
        TEST_ASSERT_FALSE(session_store_find(&store, id, now_ms, &found));
    }
    (void)snprintf(id, sizeof id, "%s0", session.id);
    TEST_ASSERT_FALSE(session_store_find(&store, id, now_ms, &found));
    TEST_ASSERT_TRUE(session_store_find(&store, session.id, now_ms, &found));
}

void test_SWR_SESS_009_a_session_in_which_nothing_is_written_ends(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    now_ms += IDLE_MS - 1U;
    TEST_ASSERT_EQUAL_UINT32(1U, session_left(&session, now_ms).idle_s);
    TEST_ASSERT_EQUAL_INT(SESSION_PASS, session_store_judge(&store, session.id, NULL, SESSION_READS,
                                                            ROLE_OBSERVER, now_ms));
    TEST_ASSERT_TRUE(is_live());
    now_ms += 1U;
    TEST_ASSERT_FALSE(is_live());
    TEST_ASSERT_EQUAL_INT(SESSION_NONE, session_store_judge(&store, session.id, session.csrf,
                                                            SESSION_ACTS, ROLE_OBSERVER, now_ms));
    session_store_tick(&store, now_ms);
    TEST_ASSERT_NOT_NULL(strstr(said, "3 anna: session ended: nothing was done in it."));
}

void test_SWR_SESS_009_writing_keeps_it_awake_until_it_is_too_old(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    const uint64_t opened_ms = now_ms;
    for (now_ms += IDLE_MS - 1U; now_ms < (opened_ms + MOST_MS); now_ms += IDLE_MS - 1U) {
        TEST_ASSERT_EQUAL_INT(SESSION_PASS,
                              session_store_judge(&store, session.id, session.csrf, SESSION_ACTS,
                                                  ROLE_OBSERVER, now_ms));
    }
    now_ms = opened_ms + MOST_MS - 1U;
    TEST_ASSERT_TRUE(is_live());
    now_ms++;
    TEST_ASSERT_FALSE(is_live());
    session_store_tick(&store, now_ms);
    TEST_ASSERT_NOT_NULL(strstr(said, "it was too old"));
}

/* Threads ask the time before they wait for each other. */
void test_SWR_SESS_009_who_comes_with_an_earlier_time_ends_no_session(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    now_ms -= 1U;
    session_store_tick(&store, now_ms);
    TEST_ASSERT_TRUE(is_live());
    TEST_ASSERT_EQUAL_UINT32(LIMIT_SESSION_IDLE_S, session_left(&session, now_ms).idle_s);
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

void test_SWR_HTTP_035_what_a_page_does_by_itself_keeps_no_session_awake(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    now_ms += IDLE_MS - 1U;
    TEST_ASSERT_EQUAL_INT(SESSION_CSRF, session_store_judge(&store, session.id, NULL, SESSION_RUNS,
                                                            ROLE_OBSERVER, now_ms));
    TEST_ASSERT_EQUAL_INT(SESSION_PASS, session_store_judge(&store, session.id, session.csrf,
                                                            SESSION_RUNS, ROLE_OBSERVER, now_ms));
    now_ms++;
    TEST_ASSERT_FALSE(is_live());
}

void test_SWR_SESS_009_who_logs_out_is_out(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    session_store_log_out(&store, session.id, now_ms);
    TEST_ASSERT_FALSE(is_live());
    session_store_log_out(&store, session.id, now_ms);
    TEST_ASSERT_EQUAL_STRING("0 anna: logged in as operator, by password.\n2 anna: logged out.\n",
                             said);
}

void test_SWR_SESS_011_writing_needs_the_token_and_reading_does_not(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    TEST_ASSERT_EQUAL_INT(SESSION_CSRF, session_store_judge(&store, session.id, NULL, SESSION_ACTS,
                                                            ROLE_SERVICE, now_ms));
    TEST_ASSERT_EQUAL_INT(SESSION_CSRF, session_store_judge(&store, session.id, "", SESSION_ACTS,
                                                            ROLE_OBSERVER, now_ms));
    TEST_ASSERT_EQUAL_INT(SESSION_CSRF, session_store_judge(&store, session.id, session.id,
                                                            SESSION_ACTS, ROLE_OBSERVER, now_ms));
    TEST_ASSERT_EQUAL_INT(SESSION_PASS, session_store_judge(&store, session.id, session.csrf,
                                                            SESSION_ACTS, ROLE_OBSERVER, now_ms));
    TEST_ASSERT_EQUAL_INT(SESSION_PASS, session_store_judge(&store, session.id, NULL, SESSION_READS,
                                                            ROLE_OBSERVER, now_ms));
}

void test_SWR_SESS_013_a_role_may_what_those_before_it_may(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    TEST_ASSERT_EQUAL_INT(
        SESSION_PASS, session_store_judge(&store, session.id, NULL, false, ROLE_OPERATOR, now_ms));
    TEST_ASSERT_EQUAL_INT(
        SESSION_ROLE, session_store_judge(&store, session.id, NULL, false, ROLE_ENGINEER, now_ms));
    TEST_ASSERT_EQUAL_INT(SESSION_ROLE, session_store_judge(&store, session.id, session.csrf,
                                                            SESSION_ACTS, ROLE_SERVICE, now_ms));
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

void test_SWR_SESS_022_whose_account_is_changed_is_out(void)
{
    static const char *const changes[] = {"role", "password", "removed"};
    static accounts_t accounts;
    static char error[200];
    TEST_ASSERT_TRUE(accounts_read(&accounts, file, error, sizeof error));
    const account_t anna = *accounts_find(&accounts, "anna");
    for (unsigned i = 0U; i < 3U; i++) {
        account_t changed = anna;
        TEST_ASSERT_TRUE(accounts_put(&accounts, &anna));
        write_accounts(&accounts);
        TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
        session_store_tick(&store, now_ms += SECOND);
        TEST_ASSERT_TRUE(is_live());
        changed.role = (i == 0U) ? ROLE_OBSERVER : anna.role;
        if (i == 1U) {
            changed.hash[10] = (anna.hash[10] == '/') ? '.' : '/';
        }
        TEST_ASSERT_TRUE((i == 2U) ? accounts_remove(&accounts, "anna")
                                   : accounts_put(&accounts, &changed));
        write_accounts(&accounts);
        session_store_tick(&store, now_ms += SECOND);
        TEST_ASSERT_FALSE_MESSAGE(is_live(), changes[i]);
    }
    TEST_ASSERT_EQUAL_UINT(3U, count_said("3 anna: session ended: the account was changed."));
}

void test_SWR_SESS_022_accounts_that_cannot_be_read_end_no_session(void)
{
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter("anna", "correct horse"));
    (void)unlink(file);
    session_store_tick(&store, now_ms += SECOND);
    TEST_ASSERT_TRUE(is_live());
}

void test_SWR_SESS_022_the_code_has_no_account(void)
{
    session_store_init(&store, NULL, witness, said);
    TEST_ASSERT_TRUE(session_store_make_code(&store));
    TEST_ASSERT_EQUAL_INT(LOGIN_OPENED, enter_by_code(store.code));
    session_store_tick(&store, now_ms += SECOND);
    TEST_ASSERT_TRUE(is_live());
}
