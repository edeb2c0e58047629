/* SPDX-License-Identifier: Apache-2.0 */
#include "session/session_desk.h"

#include "session/password.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>

#define CODE_NAME "code" /* Of who has logged in by it. */
#define GROUP 4U
#define BUSY_S 1U

static void tell(const session_desk_t *self, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void tell(const session_desk_t *self, const char *format, ...)
{
    char line[SESSION_LINE_SIZE];
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    self->witness(line);
}

void session_desk_init(session_desk_t *self, const char *accounts_file, session_witness_t witness)
{
    (void)memset(self, 0, sizeof *self);
    (void)pthread_mutex_init(&self->lock, NULL);
    self->accounts_file = accounts_file;
    self->witness = witness;
}

bool session_desk_make_code(session_desk_t *self)
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

bool session_desk_has_code(session_desk_t *self)
{
    (void)pthread_mutex_lock(&self->lock);
    const bool has_code = self->code[0] != '\0';
    (void)pthread_mutex_unlock(&self->lock);
    return has_code;
}

/* What a stranger calls himself may be anything. */
static const char *shown(const login_t *login)
{
    if (login->name == NULL) {
        return CODE_NAME;
    }
    return account_is_name(login->name) ? login->name : "an impossible name";
}

/* What is counted together: whoever comes with a code, or with this name. */
static const char *counted(const login_t *login)
{
    return (login->name != NULL) ? login->name : "";
}

/* Takes the right to look at a password. False: `wait_s` says when to come again. */
static bool claim(session_desk_t *self, const login_t *login, uint64_t now_ms, uint32_t *wait_s)
{
    (void)pthread_mutex_lock(&self->lock);
    *wait_s = login_delay_left_s(&self->delay, counted(login), now_ms);
    if (self->is_looking && (*wait_s == 0U)) {
        *wait_s = BUSY_S;
    }
    const bool is_free = *wait_s == 0U;
    self->is_looking = self->is_looking || is_free;
    self->untold += is_free ? 0U : 1U;
    (void)pthread_mutex_unlock(&self->lock);
    return is_free;
}

/* Looks at the password without the lock. The accounts are read anew: who was removed is gone. */
static bool is_right_password(const session_desk_t *self, const login_t *login, role_t *role)
{
    char error[SESSION_LINE_SIZE];
    accounts_t accounts;

    accounts.count = 0U;
    if ((self->accounts_file != NULL) &&
        !accounts_read(&accounts, self->accounts_file, error, sizeof error)) {
        tell(self, "%s", error);
    }
    const account_t *account = accounts_find(&accounts, login->name);
    const bool is_right =
        password_matches(login->password, (account != NULL) ? account->hash : NULL);
    *role = (account != NULL) ? account->role : ROLE_OBSERVER;
    explicit_bzero(&accounts, sizeof accounts);
    return is_right;
}

/* With the lock; the code is no more. */
static bool take_code(session_desk_t *self, const char *code)
{
    const bool is_right = (self->code[0] != '\0') && password_is_equal(code, self->code);

    if (is_right) {
        explicit_bzero(self->code, sizeof self->code);
    }
    return is_right;
}

/* With the lock. */
static login_verdict_t open_session(session_desk_t *self, const login_t *login, role_t role,
                                    uint64_t now_ms, session_t *opened)
{
    session_t *old =
        (login->id != NULL) ? session_table_find(&self->table, login->id, now_ms) : NULL;

    if (old != NULL) {
        session_table_close(old);
    }
    const session_t *session = session_table_open(
        &self->table, (login->name != NULL) ? login->name : CODE_NAME, role, now_ms);
    if (session == NULL) {
        return LOGIN_FULL;
    }
    *opened = *session;
    return LOGIN_OPENED;
}

static void tell_verdict(session_desk_t *self, const login_t *login, login_verdict_t verdict,
                         const session_t *opened, uint32_t untold)
{
    static const char *const by[] = {"by password", "by the code of the first login"};

    if (untold > 0U) {
        tell(self, "%u logins were not looked at: they came too soon.", (unsigned)untold);
    }
    if (verdict == LOGIN_OPENED) {
        tell(self, "%s logged in as %s, %s.", opened->name, account_role_word(opened->role),
             by[(login->name == NULL) ? 1 : 0]);
    } else {
        tell(self, "A login of %s was refused: %s.", shown(login),
             (verdict == LOGIN_FULL) ? "there are too many sessions"
                                     : "name, password or code is wrong");
    }
}

login_verdict_t session_desk_log_in(session_desk_t *self, const login_t *login, uint64_t now_ms,
                                    session_t *opened, uint32_t *wait_s)
{
    role_t role = ROLE_ENGINEER;
    login_verdict_t verdict = LOGIN_REFUSED;

    session_desk_tick(self, now_ms);
    if (!claim(self, login, now_ms, wait_s)) {
        return LOGIN_LATER;
    }
    bool is_right = (login->name != NULL) && is_right_password(self, login, &role);
    (void)pthread_mutex_lock(&self->lock);
    self->is_looking = false;
    is_right = is_right || ((login->code != NULL) && take_code(self, login->code));
    login_delay_note(&self->delay, counted(login), is_right, now_ms);
    if (is_right) {
        verdict = open_session(self, login, role, now_ms, opened);
    }
    const uint32_t untold = self->untold;
    self->untold = 0U;
    (void)pthread_mutex_unlock(&self->lock);
    tell_verdict(self, login, verdict, opened, untold);
    return verdict;
}

bool session_desk_find(session_desk_t *self, const char *id, uint64_t now_ms, session_t *session)
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
static session_verdict_t judge(session_t *session, const char *csrf, bool is_writing, role_t role,
                               uint64_t now_ms)
{
    if (session == NULL) {
        return SESSION_NONE;
    }
    if (is_writing && ((csrf == NULL) || !password_is_equal(csrf, session->csrf))) {
        return SESSION_CSRF;
    }
    if (session->role < role) {
        return SESSION_ROLE;
    }
    session->used_ms = is_writing ? now_ms : session->used_ms;
    return SESSION_PASS;
}

session_verdict_t session_desk_judge(session_desk_t *self, const char *id, const char *csrf,
                                     bool is_writing, role_t role, uint64_t now_ms)
{
    (void)pthread_mutex_lock(&self->lock);
    session_t *session = (id != NULL) ? session_table_find(&self->table, id, now_ms) : NULL;
    const session_verdict_t verdict = judge(session, csrf, is_writing, role, now_ms);
    (void)pthread_mutex_unlock(&self->lock);
    return verdict;
}

void session_desk_log_out(session_desk_t *self, const char *id, uint64_t now_ms)
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
        tell(self, "%s logged out.", ended.name);
    }
}

void session_desk_tick(session_desk_t *self, uint64_t now_ms)
{
    bool is_one = true;

    while (is_one) {
        session_t ended;
        (void)pthread_mutex_lock(&self->lock);
        is_one = session_table_take_ended(&self->table, now_ms, &ended);
        (void)pthread_mutex_unlock(&self->lock);
        if (is_one) {
            tell(self, "The session of %s has ended: %s.", ended.name,
                 (session_left(&ended, now_ms).most_s == 0U) ? "it was too old"
                                                             : "nothing was done in it");
        }
    }
}
