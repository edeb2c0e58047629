/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a user with the password gets a session that no other can guess, and that ends
 * by its limits, by a logout or with its account. */
#include "unity.h"

#include "http/login/account.h"
#include "http/login/password.h"
#include "http/login/session_store.h"
#include "http/login/session_table.h"
#include "unit/support/session_world.inc"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define IDLE_MS (LIMIT_SESSION_IDLE_S * SECOND)
#define MOST_MS (LIMIT_SESSION_MOST_S * SECOND)

void setUp(void)
{
    begin_sessions();
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
