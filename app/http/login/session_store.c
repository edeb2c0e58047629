/* SPDX-License-Identifier: Apache-2.0 */
#include "http/login/session_store.h"

#include "http/login/passed.h"
#include "http/login/password.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>

#define CODE_NAME "code" /* Name of a client that has logged in by it. */
#define STRANGER "?"
#define OWN_NAME "http"     /* The name of this program in the log. */
#define NOTE_TEXT_SIZE 321U /* A cause, an address and a count. */
#define ENDED_MOST 2U       /* Sessions that one login ends. */
#define GROUP 4U
#define BUSY_S 1U
#define MS_PER_S 1000U
#define REFUSAL_PAUSE_S 1U /* Between two reports. */
#define COMPARISON_PAUSE_S 1U

static void report(const session_store_t *self, note_kind_t kind, const char *who,
                   const char *format, ...) __attribute__((format(printf, 4, 5)));

static void report(const session_store_t *self, note_kind_t kind, const char *who,
                   const char *format, ...)
{
    char text[NOTE_TEXT_SIZE];
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    self->witness(self->witness_owner, kind, who, text);
}

void session_store_init(session_store_t *self, const char *accounts_file, session_witness_t witness,
                        void *owner)
{
    (void)memset(self, 0, sizeof *self);
    (void)pthread_mutex_init(&self->lock, NULL);
    self->accounts_file = accounts_file;
    self->witness = witness;
    self->witness_owner = owner;
    device_key_make(&self->key);
}

bool session_store_make_code(session_store_t *self)
{
    static const char signs[] = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789"; /* 32 that are not mixed up. */
    unsigned char bytes[SESSION_CODE_SIZE];

    if (getrandom(bytes, sizeof bytes, 0U) != (ssize_t)sizeof bytes) {
        return false;
    }
    for (size_t i = 0U; i < (SESSION_CODE_SIZE - 1U); i++) {
        const bool is_between = (i % (GROUP + 1U)) == GROUP;
        self->code[i] = is_between ? '-' : signs[bytes[i] % (sizeof signs - 1U)];
    }
    self->code[SESSION_CODE_SIZE - 1U] = '\0';
    return true;
}

bool session_store_has_code(session_store_t *self)
{
    (void)pthread_mutex_lock(&self->lock);
    const bool has_code = self->code[0] != '\0';
    (void)pthread_mutex_unlock(&self->lock);
    return has_code;
}

/* The name that a stranger sends may be any text. */
static const char *shown(const login_t *login)
{
    if (login->name == NULL) {
        return CODE_NAME;
    }
    return account_is_name(login->name) ? login->name : STRANGER;
}

/* With the lock. */
static void count_refusal(session_store_t *self, const login_t *login)
{
    const char *from = (login->address != NULL) ? login->address : "";

    self->unreported++;
    (void)snprintf(self->last.who, sizeof self->last.who, "%s", shown(login));
    (void)snprintf(self->last.from, sizeof self->last.from, "%s%s",
                   (from[0] != '\0') ? " from " : "", from);
}

/* Refusals to be reported now, and the last of them; 0: they are counted until `pause_s` has passed
 * since the last report. With the lock. */
static uint32_t take_refusals(session_store_t *self, uint32_t pause_s, uint64_t now_ms,
                              refused_login_t *last)
{
    uint32_t count = 0U;

    if (passed_ms(self->reported_ms, now_ms) >= ((uint64_t)pause_s * MS_PER_S)) {
        count = self->unreported;
        self->unreported = 0U;
        self->reported_ms = (count > 0U) ? now_ms : self->reported_ms;
    }
    *last = self->last;
    return count;
}

static void note_refusal(session_store_t *self, const login_t *login, const char *why,
                         uint32_t pause_s, uint64_t now_ms)
{
    refused_login_t last;

    (void)pthread_mutex_lock(&self->lock);
    count_refusal(self, login);
    const uint32_t count = take_refusals(self, pause_s, now_ms, &last);
    (void)pthread_mutex_unlock(&self->lock);
    if (count > 1U) {
        report(self, NOTE_LOGIN_REFUSED, last.who,
               "login refused%s: %s Refused before it without a line, of any name: %u.", last.from,
               why, (unsigned)(count - 1U));
    } else if (count > 0U) {
        report(self, NOTE_LOGIN_REFUSED, last.who, "login refused%s: %s", last.from, why);
    } else {
        /* It is counted. */
    }
}

void session_store_note_refusal(session_store_t *self, const login_t *login, const char *why,
                                uint64_t now_ms)
{
    note_refusal(self, login, why, LIMIT_REFUSALS_LINE_S, now_ms);
}

/* The accounts are read anew: a removed one is not found. `account` is changed if there is one. */
static bool find_account(const session_store_t *self, const char *name, account_t *account,
                         char why[SESSION_TEXT_SIZE])
{
    accounts_t accounts;

    accounts.count = 0U;
    if (self->accounts_file != NULL) {
        (void)accounts_read(&accounts, self->accounts_file, why, SESSION_TEXT_SIZE);
    }
    const account_t *found = accounts_find(&accounts, name);
    if (found != NULL) {
        *account = *found;
    }
    explicit_bzero(&accounts, sizeof accounts);
    return found != NULL;
}

bool session_store_write_mark(const session_store_t *self, const char *name,
                              char mark[DEVICE_MARK_SIZE])
{
    return device_mark_make(&self->key, name, mark);
}

/* How failures of this login are counted. Those of the code are not: 60 bits cannot be guessed. */
static login_name_t counted_as(const session_store_t *self, const login_t *login, bool is_known)
{
    const login_name_t who = {.name = login->name,
                              .address = login->address,
                              .is_known = is_known,
                              .is_marked = is_known &&
                                           device_mark_fits(&self->key, login->name, login->mark)};
    return who;
}

/* Takes the right to look at a password: LOGIN_OPENED; otherwise `wait_s` says when to come again.
 */
static login_verdict_t claim(session_store_t *self, const login_t *login, login_name_t who,
                             uint64_t now_ms, uint32_t *wait_s)
{
    login_verdict_t verdict = LOGIN_OPENED;

    (void)pthread_mutex_lock(&self->lock);
    *wait_s = login_delay_left_s(&self->delay, who, now_ms);
    if (*wait_s > 0U) {
        verdict = LOGIN_LATER;
    } else if (self->is_looking) {
        verdict = LOGIN_BUSY;
        *wait_s = BUSY_S;
    } else {
        self->is_looking = true;
    }
    if (verdict != LOGIN_OPENED) {
        count_refusal(self, login);
    }
    (void)pthread_mutex_unlock(&self->lock);
    return verdict;
}

/* With the lock. Opens one in the place of `gone`, if there is one, which stays when that makes no
 * room. */
static const session_t *open_instead(session_store_t *self, const account_t *account,
                                     uint64_t now_ms, session_t *gone, session_t *ended)
{
    const session_t *opened = NULL;

    if (gone != NULL) {
        *ended = *gone;
        session_table_close(gone);
        opened = session_table_open(&self->table, account, now_ms);
        *gone = (opened == NULL) ? *ended : *gone;
        ended->is_open = opened != NULL;
    }
    return opened;
}

/* With the lock. The replaced sessions are copied to `ended`: the one that the client had, and one
 * that was left, where there is no room otherwise. */
static login_verdict_t open_session(session_store_t *self, const login_t *login,
                                    const account_t *account, uint64_t now_ms, session_t *opened,
                                    session_t ended[ENDED_MOST])
{
    session_t *had =
        (login->id != NULL) ? session_table_find(&self->table, login->id, now_ms) : NULL;
    const session_t *session = (had != NULL) ? open_instead(self, account, now_ms, had, &ended[0])
                                             : session_table_open(&self->table, account, now_ms);

    if (session == NULL) {
        session_t *left = session_table_find_left(&self->table, account, now_ms);
        session = open_instead(self, account, now_ms, left, &ended[1]);
        if ((session != NULL) && (had != NULL)) {
            ended[0] = *had;
            session_table_close(had);
        }
    }
    if (session == NULL) {
        return LOGIN_FULL;
    }
    *opened = *session;
    return LOGIN_OPENED;
}

static void report_opened(const session_store_t *self, const login_t *login,
                          const session_t *opened, const session_t ended[ENDED_MOST])
{
    for (size_t i = 0U; i < ENDED_MOST; i++) {
        if (ended[i].is_open) {
            report(self, NOTE_SESSION_ENDED, ended[i].account.name,
                   "session ended: another login took its place.");
        }
    }
    report(self, NOTE_LOGIN, opened->account.name, "logged in as %s, %s.",
           account_role_word(opened->account.role),
           (login->name == NULL) ? "by the code of the first login" : "by password");
}

/* LOGIN_OPENED: it is right. `account` NULL: none has that name. */
static login_verdict_t judge_password(session_store_t *self, const login_t *login,
                                      const account_t *account, uint64_t now_ms, uint32_t *wait_s)
{
    const login_name_t who = counted_as(self, login, account != NULL);
    const login_verdict_t claimed = claim(self, login, who, now_ms, wait_s);

    if (claimed != LOGIN_OPENED) {
        return claimed;
    }
    const bool is_right =
        password_matches(login->password, (account != NULL) ? account->hash : NULL);
    (void)pthread_mutex_lock(&self->lock);
    self->is_looking = false;
    login_delay_note(&self->delay, who, is_right, now_ms);
    (void)pthread_mutex_unlock(&self->lock);
    return is_right ? LOGIN_OPENED : LOGIN_REFUSED;
}

/* The same. The code is no more. */
static login_verdict_t judge_code(session_store_t *self, const char *code)
{
    (void)pthread_mutex_lock(&self->lock);
    const bool is_right =
        (self->code[0] != '\0') && (code != NULL) && password_is_equal(code, self->code);
    if (is_right) {
        explicit_bzero(self->code, sizeof self->code);
    }
    (void)pthread_mutex_unlock(&self->lock);
    return is_right ? LOGIN_OPENED : LOGIN_REFUSED;
}

static login_verdict_t let_in(session_store_t *self, const login_t *login, const account_t *account,
                              uint64_t now_ms, session_t *opened)
{
    session_t ended[ENDED_MOST] = {{.is_open = false}, {.is_open = false}};

    (void)pthread_mutex_lock(&self->lock);
    const login_verdict_t verdict = open_session(self, login, account, now_ms, opened, ended);
    (void)pthread_mutex_unlock(&self->lock);
    if (verdict == LOGIN_OPENED) {
        report_opened(self, login, opened, ended);
    } else {
        note_refusal(self, login, "there are too many sessions, of it or in all.", REFUSAL_PAUSE_S,
                     now_ms);
    }
    return verdict;
}

login_verdict_t session_store_log_in(session_store_t *self, const login_t *login, uint64_t now_ms,
                                     session_t *opened, uint32_t *wait_s)
{
    char why[SESSION_TEXT_SIZE] = "name, password or code is wrong.";
    account_t account = {.name = CODE_NAME, .role = ROLE_ENGINEER};

    session_store_tick(self, now_ms);
    const bool is_named = login->name != NULL;
    const bool is_known = is_named && find_account(self, login->name, &account, why);
    const login_verdict_t verdict =
        is_named ? judge_password(self, login, is_known ? &account : NULL, now_ms, wait_s)
                 : judge_code(self, login->code);
    if (verdict == LOGIN_REFUSED) {
        note_refusal(self, login, why, REFUSAL_PAUSE_S, now_ms);
    }
    return (verdict == LOGIN_OPENED) ? let_in(self, login, &account, now_ms, opened) : verdict;
}

bool session_store_find(session_store_t *self, const char *id, uint64_t now_ms, session_t *session)
{
    if (id == NULL) {
        return false;
    }
    (void)pthread_mutex_lock(&self->lock);
    const session_t *found = session_table_find(&self->table, id, now_ms);
    if (found != NULL) {
        *session = *found;
    }
    (void)pthread_mutex_unlock(&self->lock);
    return found != NULL;
}

/* With the lock. */
static session_verdict_t judge(session_t *session, const char *csrf, session_use_t use, role_t role,
                               uint64_t now_ms)
{
    if (session == NULL) {
        return SESSION_NONE;
    }
    if ((use != SESSION_READS) && ((csrf == NULL) || !password_is_equal(csrf, session->csrf))) {
        return SESSION_CSRF;
    }
    if (session->account.role < role) {
        return SESSION_ROLE;
    }
    session->seen_ms =
        ((use != SESSION_READS) && (now_ms > session->seen_ms)) ? now_ms : session->seen_ms;
    session->used_ms =
        ((use == SESSION_ACTS) && (now_ms > session->used_ms)) ? now_ms : session->used_ms;
    return SESSION_PASS;
}

session_verdict_t session_store_judge(session_store_t *self, const char *id, const char *csrf,
                                      session_use_t use, role_t role, uint64_t now_ms)
{
    (void)pthread_mutex_lock(&self->lock);
    session_t *session = (id != NULL) ? session_table_find(&self->table, id, now_ms) : NULL;
    const session_verdict_t verdict = judge(session, csrf, use, role, now_ms);
    (void)pthread_mutex_unlock(&self->lock);
    return verdict;
}

void session_store_log_out(session_store_t *self, const char *id, uint64_t now_ms)
{
    session_t ended = {.is_open = false};

    (void)pthread_mutex_lock(&self->lock);
    session_t *session = session_table_find(&self->table, id, now_ms);
    if (session != NULL) {
        ended = *session;
        session_table_close(session);
    }
    (void)pthread_mutex_unlock(&self->lock);
    if (ended.is_open) {
        report(self, NOTE_LOGOUT, ended.account.name, "logged out.");
    }
}

static bool is_account_unchanged(const account_t *account, accounts_t *accounts)
{
    const account_t *now = accounts_find(accounts, account->name);

    return (now != NULL) && (now->role == account->role) && (strcmp(now->hash, account->hash) == 0);
}

/* Ends the first session whose account is not in `accounts` as it was, and copies it to `ended`. */
static bool take_changed(session_store_t *self, accounts_t *accounts, session_t *ended)
{
    bool is_one = false;

    (void)pthread_mutex_lock(&self->lock);
    for (size_t i = 0U; (i < LIMIT_SESSIONS) && !is_one; i++) {
        session_t *session = &self->table.sessions[i];
        is_one = session->is_open && !is_account_unchanged(&session->account, accounts);
        if (is_one) {
            *ended = *session;
            session_table_close(session);
        }
    }
    (void)pthread_mutex_unlock(&self->lock);
    return is_one;
}

/* A file that cannot be read ends no session. */
static void compare_accounts(session_store_t *self)
{
    char error[SESSION_TEXT_SIZE];
    accounts_t accounts;
    session_t ended;

    if (accounts_read(&accounts, self->accounts_file, error, sizeof error)) {
        while (take_changed(self, &accounts, &ended)) {
            report(self, NOTE_SESSION_ENDED, ended.account.name,
                   "session ended: the account was changed.");
        }
    }
    explicit_bzero(&accounts, sizeof accounts);
}

static bool is_comparison_due(session_store_t *self, uint64_t now_ms)
{
    (void)pthread_mutex_lock(&self->lock);
    const bool is_due = (self->accounts_file != NULL) &&
                        (passed_ms(self->compared_ms, now_ms) >= (COMPARISON_PAUSE_S * MS_PER_S));
    self->compared_ms = is_due ? now_ms : self->compared_ms;
    (void)pthread_mutex_unlock(&self->lock);
    return is_due;
}

static void end_old(session_store_t *self, uint64_t now_ms)
{
    bool is_one = true;

    while (is_one) {
        session_t ended;
        (void)pthread_mutex_lock(&self->lock);
        is_one = session_table_take_ended(&self->table, now_ms, &ended);
        (void)pthread_mutex_unlock(&self->lock);
        if (is_one) {
            report(self, NOTE_SESSION_ENDED, ended.account.name, "session ended: %s.",
                   (session_left(&ended, now_ms).most_s == 0U) ? "it was too old"
                                                               : "nothing was done in it");
        }
    }
}

void session_store_tick(session_store_t *self, uint64_t now_ms)
{
    refused_login_t last;

    (void)pthread_mutex_lock(&self->lock);
    const uint32_t count = take_refusals(self, LIMIT_REFUSALS_LINE_S, now_ms, &last);
    (void)pthread_mutex_unlock(&self->lock);
    if (count > 0U) {
        report(
            self, NOTE_LOGIN_REFUSED, OWN_NAME,
            "logins refused that came too soon to be judged or logged, of any name: %u; the last "
            "of %s%s.",
            (unsigned)count, last.who, last.from);
    }
    end_old(self, now_ms);
    if (is_comparison_due(self, now_ms)) {
        compare_accounts(self);
    }
}
