/* SPDX-License-Identifier: Apache-2.0 */
#include "site/served/served.h"

#include "base/contract.h"
#include "http/server/http_routes.h"
#include "http/server/http_server.h"
#include "limits/requirement_limits.h"
#include "robot/app/robots.h"
#include "site/served/connection.h"
#include "site/served/served_robot.h"
#include "site/served/served_stream.h"
#include "site/watch.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#define TICK_US 50000U /* As in boresight-http. */
#define US_PER_S UINT64_C(1000000)
#define TEXT_SIZE 65536U
#define ANSWER_SIZE (256U * 1024U)
#define ORDER_SIZE 256U

static const char contract_module[] = "served";

static char text[TEXT_SIZE + 1U];
static char answer[ANSWER_SIZE];
static exchange_t *exchange;
static http_server_t server;

void contract_broken(const char *module, uint32_t id)
{
    (void)snprintf(text, sizeof text, "Contract %s/%u is broken, report this.", module,
                   (unsigned)id);
    __builtin_trap();
}

char *served_text(void)
{
    return text;
}

uint32_t served_text_size(void)
{
    return TEXT_SIZE;
}

const char *served_answer(void)
{
    return answer;
}

bool served_start(uint32_t seed, uint32_t utc_s)
{
    text[TEXT_SIZE] = '\0';
    const robot_t *const robot = robots_find(text);
    if (robot == NULL) {
        return false;
    }
    exchange = served_robot_start(robot, seed, US_PER_S * utc_s);
    (void)memset(&server, 0, sizeof server);
    const http_server_config_t config = {
        .exchange = exchange,
        .guard = {.address = "127.0.0.1", .port = 80U, .page_port = 80U},
        .instance = SERVED_ROBOT_BOX,
        .box = SERVED_ROBOT_BOX,
        .recordings = ""};
    http_server_init(&server, &config);
    (void)session_store_make_code(&server.sessions);
    (void)snprintf(answer, sizeof answer, "%s", server.sessions.code);
    return true;
}

/* A number that a command of a scene has is not given again: its answer would be taken for the
 * other's. */
static void skip_numbers(void)
{
    const closed_loop_t *const loop = watch_loop();

    for (uint32_t i = 0U; i < loop->command_count; i++) {
        const uint32_t id = loop->commands[i].id;
        const bool is_ahead = (id - server.acts.commands) <= (uint32_t)INT32_MAX;
        if (is_ahead && (loop->commands[i].source == (uint32_t)COMMAND_SOURCE_HTTP)) {
            server.acts.commands = id;
        }
    }
}

static void pass_cycle(void)
{
    skip_numbers();
    served_robot_step();
    if ((served_robot_time_us() % TICK_US) == 0U) {
        exchange_beat(exchange, EXCHANGE_HTTP);
        http_server_tick(&server);
        served_stream_go_on(&server);
    }
}

void served_step(uint32_t cycles)
{
    REQUIRE(310U, served_robot_is_started());
    for (uint32_t i = 0U; i < cycles; i++) {
        pass_cycle();
    }
}

bool served_order(void)
{
    char order[ORDER_SIZE];

    REQUIRE(313U, served_robot_is_started());
    (void)snprintf(order, sizeof order, "%.*s", (int)sizeof order - 1, text);
    return served_robot_order(order, text, (uint32_t)sizeof text);
}

command_t *served_command(void)
{
    REQUIRE(314U, served_robot_is_started());
    return served_robot_command();
}

uint32_t served_ask(uint32_t size)
{
    struct mg_connection connection;

    REQUIRE(311U, served_robot_is_started());
    REQUIRE(312U, size <= TEXT_SIZE);
    text[size] = '\0';
    const bool is_read = connection_read(&connection, text, size, answer, sizeof answer);
    connection.user_data = &server;
    if (is_read) {
        (void)http_routes_answer(&server, &connection);
    }
    return (uint32_t)connection.size;
}

uint32_t served_listen(void)
{
    return (uint32_t)served_stream_take(answer);
}

uint32_t served_cycles(void)
{
    return (uint32_t)(served_robot_time_us() / LIMIT_CYCLE_US);
}

/* Waiting for control counts cycles. */
int nanosleep(const struct timespec *pause, struct timespec *left)
{
    const uint64_t us =
        ((uint64_t)pause->tv_sec * US_PER_S) + ((uint64_t)pause->tv_nsec / UINT64_C(1000));

    (void)left;
    for (uint64_t passed = 0U; passed < us; passed += LIMIT_CYCLE_US) {
        pass_cycle();
    }
    return 0;
}
