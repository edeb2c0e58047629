/* SPDX-License-Identifier: Apache-2.0 */
#include "http/call/http_login_gate.h"

#include "http/call/http_reply.h"
#include "interface/app/handlers.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "request/request_headers.h"

#include <stdio.h>
#include <string.h>

#define COOKIE_NAME_SIZE 160U
#define COOKIE_SIZE 384U
#define SENTENCE_SIZE 96U
#define ADDRESS_SIZE 64U
#define LOGIN_PATH "/api/v1/session"
#define NOT_SENT 499
#define NOT_BY_TLS "by TLS a name and password are taken, and no code."
#define NOT_IN_CLEAR "no login is taken in the clear but at the loopback listener."

bool http_login_gate_is_tls(const http_server_t *server, const struct mg_connection *connection)
{
    return (server->front != NULL) &&
           (mg_get_request_info(connection)->server_port == (int)server->front->console_from);
}

static bool is_plain_loopback(const http_server_t *server, const struct mg_connection *connection)
{
    return !http_login_gate_is_tls(server, connection) &&
           (strncmp(server->guard.address, "127.", 4U) == 0);
}

/* Cookies do not know ports: each instance has a name of its own. A browser takes one that begins
 * with __Host- over TLS alone. */
static void name_cookie(const http_server_t *server, bool is_tls, char name[COOKIE_NAME_SIZE])
{
    (void)snprintf(name, COOKIE_NAME_SIZE, "%sboresight-%s", is_tls ? "__Host-" : "",
                   server->instance);
}

/* The session that the client says it has; NULL: it says none. */
static const char *find_id(const http_server_t *server, const struct mg_connection *connection,
                           char id[SESSION_TOKEN_SIZE])
{
    char name[COOKIE_NAME_SIZE];
    name_cookie(server, http_login_gate_is_tls(server, connection), name);
    const char *cookies = mg_get_header(connection, "Cookie");
    return request_headers_cookie(cookies, name, id, SESSION_TOKEN_SIZE) ? id : NULL;
}

/* One cookie for each account, so that a shared browser knows them all. No name has a dot, and no
 * session's cookie begins so. */
static void name_mark(const http_server_t *server, bool is_tls, const char *who,
                      char name[COOKIE_NAME_SIZE])
{
    (void)snprintf(name, COOKIE_NAME_SIZE, "%sboresight_device-%s.%s", is_tls ? "__Secure-" : "",
                   server->instance, who);
}

/* The mark that the browser shows for the name that logs in; NULL: none. */
static const char *find_mark(const http_server_t *server, const struct mg_connection *connection,
                             const login_t *login, char mark[DEVICE_MARK_SIZE])
{
    char name[COOKIE_NAME_SIZE];
    if ((login->name == NULL) || !account_is_name(login->name)) {
        return NULL;
    }
    name_mark(server, http_login_gate_is_tls(server, connection), login->name, name);
    const char *cookies = mg_get_header(connection, "Cookie");
    return request_headers_cookie(cookies, name, mark, DEVICE_MARK_SIZE) ? mark : NULL;
}

/* All that comes by TLS has the address of the TLS program, which others have here as well. */
static void write_address(const http_server_t *server, const struct mg_connection *connection,
                          char address[ADDRESS_SIZE])
{
    (void)snprintf(address, ADDRESS_SIZE, "%s %s",
                   http_login_gate_is_tls(server, connection) ? "TLS" : "plain",
                   mg_get_request_info(connection)->remote_addr);
}

static int refuse(struct mg_connection *connection, problem_t problem)
{
    const int status = http_reply_refuse(connection, problem);
    return (status != 0) ? status : NOT_SENT;
}

/* A page keeps authority, and the pedal of a simulated box, without an act of the user. */
static session_use_t use_of(const route_t *route)
{
    const bool is_read = strcmp(route->method, "GET") == 0;
    const bool is_renewal = (route->id == ROUTE_RENEW_AUTHORITY) || (route->id == ROUTE_KEEP_BOX);
    const session_use_t use = is_renewal ? SESSION_RUNS : SESSION_ACTS;
    return is_read ? SESSION_READS : use;
}

int http_login_gate_judge(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    const session_use_t use = use_of(call->route);
    char id[SESSION_TOKEN_SIZE];
    if (call->route->is_for_anyone ||
        ((use == SESSION_READS) && (call->route->role == ROLE_OBSERVER) &&
         is_plain_loopback(server, connection))) {
        return 0;
    }
    switch (session_store_judge(&server->sessions, find_id(server, connection, id),
                                mg_get_header(connection, HTTP_LOGIN_GATE_TOKEN), use,
                                call->route->role, telemetry_now_ms())) {
    case SESSION_PASS:
        return 0;
    case SESSION_CSRF:
        return refuse(connection, PROBLEM_TOKEN_REFUSED);
    case SESSION_ROLE:
        return refuse(connection, PROBLEM_ROLE_REFUSED);
    case SESSION_NONE:
    default:
        return refuse(connection, PROBLEM_NO_SESSION);
    }
}

bool http_login_gate_find(http_server_t *server, const struct mg_connection *connection,
                          session_t *session)
{
    char id[SESSION_TOKEN_SIZE];
    return session_store_find(&server->sessions, find_id(server, connection, id),
                              telemetry_now_ms(), session);
}

bool http_login_gate_is_open(http_server_t *server, const struct mg_connection *connection)
{
    session_t session;
    return is_plain_loopback(server, connection) ||
           http_login_gate_find(server, connection, &session);
}

/* How one logs in here. */
static const char *login_way(http_server_t *server, const struct mg_connection *connection)
{
    const bool is_near = is_plain_loopback(server, connection);
    const bool is_safe = is_near || http_login_gate_is_tls(server, connection);
    const bool has_code = is_near && session_store_has_code(&server->sessions);
    if (server->sessions.accounts_file == NULL) {
        return has_code ? "code" : "none";
    }
    return is_safe ? "password" : "none";
}

typedef struct {
    const char *session; /* NULL: it stays as it is. */
    const char *device;  /* The same. */
} cookies_t;

/* A session that is not open is none. */
static int send_session(http_server_t *server, struct mg_connection *connection,
                        const session_t *session, cookies_t cookies)
{
    const session_left_t none = {.idle_s = 0U};
    const bool is_open = session->is_open;
    const session_left_t left = is_open ? session_left(session, telemetry_now_ms()) : none;
    const json_session_t reported = {.is_open = is_open,
                                     .name = is_open ? session->account.name : NULL,
                                     .role =
                                         is_open ? role_name((int32_t)session->account.role) : NULL,
                                     .token = is_open ? session->csrf : NULL,
                                     .idle_s = left.idle_s,
                                     .most_s = left.most_s,
                                     .warn_s = LIMIT_SESSION_WARN_S,
                                     .login = login_way(server, connection),
                                     .boot_id = server->identity.boot_id};
    char json[512];
    cJSON *object = json_session(&reported);
    const bool is_whole = cJSON_PrintPreallocated(object, json, (int)sizeof json, 0) != 0;
    cJSON_Delete(object);
    const http_reply_t reply = {.status = 200,
                                .type = HTTP_REPLY_JSON,
                                .cache = HTTP_REPLY_NO_STORE,
                                .cookie = cookies.session,
                                .device = cookies.device,
                                .body = json,
                                .size = strlen(json)};
    return is_whole ? http_reply_send(connection, &reply) : refuse(connection, PROBLEM_NO_MEMORY);
}

int http_login_gate_show(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    session_t session = {.is_open = false};
    const cookies_t unchanged = {.session = NULL, .device = NULL};
    (void)http_login_gate_find(server, connection, &session);
    return send_session(server, connection, &session, unchanged);
}

/* `age_s` 0 takes it away. */
static void write_cookie(const http_server_t *server, const struct mg_connection *connection,
                         const char *id, unsigned age_s, char cookie[COOKIE_SIZE])
{
    char name[COOKIE_NAME_SIZE];
    const bool is_tls = http_login_gate_is_tls(server, connection);
    name_cookie(server, is_tls, name);
    (void)snprintf(cookie, COOKIE_SIZE, "%s=%s; Path=/; Max-Age=%u; HttpOnly; SameSite=Strict%s",
                   name, id, age_s, is_tls ? "; Secure" : "");
}

/* It is sent where one logs in alone. NULL: none exists. */
static const char *write_device_cookie(http_server_t *server,
                                       const struct mg_connection *connection, const login_t *login,
                                       char cookie[COOKIE_SIZE])
{
    char name[COOKIE_NAME_SIZE];
    char mark[DEVICE_MARK_SIZE];
    const bool is_tls = http_login_gate_is_tls(server, connection);
    if ((login->name == NULL) || !session_store_write_mark(&server->sessions, login->name, mark)) {
        return NULL;
    }
    name_mark(server, is_tls, login->name, name);
    (void)snprintf(cookie, COOKIE_SIZE,
                   "%s=%s; Path=" LOGIN_PATH "; Max-Age=%u; HttpOnly; SameSite=Strict%s", name,
                   mark, (unsigned)LIMIT_DEVICE_MARK_S, is_tls ? "; Secure" : "");
    return cookie;
}

/* Name and password, or else a code. */
static bool read_login(const request_login_t *body, login_t *login, request_result_t *fault)
{
    const bool is_by_name = body->has_name && body->has_password && !body->has_code;
    const bool is_by_code = !body->has_name && !body->has_password && body->has_code;
    login->name = is_by_name ? body->name : NULL;
    login->password = is_by_name ? body->password : NULL;
    login->code = is_by_code ? body->code : NULL;
    if (!is_by_name && !is_by_code) {
        const char *missing = body->has_password ? "/name" : "/password";
        request_fault_set(fault, body->has_code ? REQUEST_UNKNOWN : REQUEST_MISSING, NULL);
        (void)snprintf(fault->place, sizeof fault->place, "%s", body->has_code ? "/code" : missing);
    }
    return is_by_name || is_by_code;
}

/* With the time to wait, for people. */
static int refuse_for(struct mg_connection *connection, const char *why, uint32_t wait_s)
{
    char sentence[SENTENCE_SIZE];
    http_problem_t problem = http_problem_of(PROBLEM_LOGIN_TOO_SOON);
    (void)snprintf(sentence, sizeof sentence, "%s: wait %u s, then log in again.", why,
                   (unsigned)wait_s);
    problem.detail = sentence;
    problem.retry_after_s = wait_s;
    return http_reply_problem(connection, &problem, NULL);
}

static int refuse_login(struct mg_connection *connection, login_verdict_t verdict, uint32_t wait_s)
{
    switch (verdict) {
    case LOGIN_LATER:
        return refuse_for(connection, "Too many logins failed", wait_s);
    case LOGIN_BUSY:
        return refuse_for(connection, "Another login is being judged", wait_s);
    case LOGIN_FULL:
        return refuse(connection, PROBLEM_SESSIONS_FULL);
    case LOGIN_REFUSED:
    case LOGIN_OPENED:
    default:
        return refuse(connection, PROBLEM_LOGIN_REFUSED);
    }
}

/**
 * Logs in.
 *
 * @satisfies SWR-SESS-012
 * @satisfies SWR-SESS-015
 * @satisfies SWR-SESS-018
 * @satisfies SWR-SESS-033
 * @satisfies SWR-SESS-321
 */
int http_login_gate_log_in(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    char id[SESSION_TOKEN_SIZE];
    char cookie[COOKIE_SIZE];
    char device_cookie[COOKIE_SIZE];
    char mark[DEVICE_MARK_SIZE];
    char address[ADDRESS_SIZE];
    session_t session;
    uint32_t wait_s = 0U;
    write_address(server, connection, address);
    login_t login = {.id = find_id(server, connection, id), .address = address};
    request_result_t fault;
    if (!read_login(&call->body.login, &login, &fault)) {
        const http_problem_t problem = http_problem_of_body(&fault);
        return http_reply_problem(connection, &problem, NULL);
    }
    const bool is_near = is_plain_loopback(server, connection);
    const bool is_tls = http_login_gate_is_tls(server, connection);
    if (!is_near && ((login.code != NULL) || !is_tls)) {
        session_store_note_refusal(&server->sessions, &login, is_tls ? NOT_BY_TLS : NOT_IN_CLEAR,
                                   telemetry_now_ms());
        return refuse(connection, PROBLEM_LOGIN_NOT_HERE);
    }
    login.mark = find_mark(server, connection, &login, mark);
    const login_verdict_t verdict =
        session_store_log_in(&server->sessions, &login, telemetry_now_ms(), &session, &wait_s);
    if (verdict != LOGIN_OPENED) {
        return refuse_login(connection, verdict, wait_s);
    }
    write_cookie(server, connection, session.id, LIMIT_SESSION_MOST_S, cookie);
    const cookies_t cookies = {.session = cookie,
                               .device =
                                   write_device_cookie(server, connection, &login, device_cookie)};
    return send_session(server, connection, &session, cookies);
}

int http_login_gate_log_out(http_server_t *server, const http_call_t *call)
{
    struct mg_connection *connection = call->connection;
    char id[SESSION_TOKEN_SIZE];
    char cookie[COOKIE_SIZE];
    const session_t none = {.is_open = false};
    if (find_id(server, connection, id) != NULL) {
        session_store_log_out(&server->sessions, id, telemetry_now_ms());
    }
    write_cookie(server, connection, "", 0U, cookie);
    const cookies_t cookies = {.session = cookie, .device = NULL};
    return send_session(server, connection, &none, cookies);
}
